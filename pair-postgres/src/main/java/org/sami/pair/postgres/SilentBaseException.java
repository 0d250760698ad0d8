package org.sami.pair.postgres;

/** The other base of a pair does not answer, and may have gone on with the session: this base waits for it, or for the word of a person. */
public final class SilentBaseException extends PairException {
    private static final long serialVersionUID = 1;

    SilentBaseException(String message) {
        super(message);
    }
}
