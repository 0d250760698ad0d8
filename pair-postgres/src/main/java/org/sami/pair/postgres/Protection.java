package org.sami.pair.postgres;

/**
 * Whether a session of a pair would go on without loss if this base were lost.
 *
 * @param text for people, a sentence without a full stop
 * @param advice what a person can do, the same; empty where there is nothing to do
 */
public record Protection(State state, String text, String advice) {
    /** Its kinds. */
    public enum State {
        /** The other base has all that is confirmed, and waits to go on with it. */
        PROTECTED,
        /** The other base's database has all that is confirmed, but no base waits there to go on with it. */
        COPIED,
        /** This base does not wait for the other. */
        ALONE,
        /** This base waits for the other, which does not answer: it stops commanding. */
        SILENT,
        /** The other base went on with the session: this one must not. */
        REPLACED,
        /** Unknown: this base's database does not answer. */
        UNKNOWN
    }
}
