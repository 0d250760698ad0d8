package org.sami.session.client;

/** What a front gets to know of its connection to a session. Called on the link's thread; must be quick. */
public interface RemoteListener {
    /**
     * The connection is lost, and is tried again by itself.
     *
     * @param words why, and until when the session was seen
     */
    void lost(String words);

    /** It is there again: what is shown is of now. */
    void back();

    /** It will not come back: the person was removed, or another session is there now. */
    void ended(String why);

    /** The person's role is another one now. */
    void rights(PersonRights now);

    /** Somebody else did something. */
    void news(String text);
}
