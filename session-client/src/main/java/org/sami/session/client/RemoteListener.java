package org.sami.session.client;

/** Receives changes of a front's connection to a session. Called on the link's thread; returns at once. */
public interface RemoteListener {
    /**
     * The connection is lost or silent, and is tried again by itself; also before the first, where a standby is waited for. Called again when another reason is known.
     *
     * @param words why, until when the session was seen, and which bases are tried
     */
    void lost(String words);

    /**
     * It is there again: what is shown is of now.
     *
     * @param base which holds the session; may be another one than before
     */
    void back(SessionAddress base);

    /** It will not come back: the person was removed, or another session is there now. */
    void ended(String why);

    /** The person's role is another one now. */
    void rights(PersonRights now);

    /** Somebody else did something. */
    void news(String text);
}
