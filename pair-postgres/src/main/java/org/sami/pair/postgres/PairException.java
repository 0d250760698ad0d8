package org.sami.pair.postgres;

import java.io.IOException;

/** Why a pair of bases cannot be made, read or used, in words for its user. */
public sealed class PairException extends IOException permits SilentBaseException {
    private static final long serialVersionUID = 1;

    /** With a sentence that names what and where. */
    public PairException(String message) {
        super(message);
    }

    /** The same, with its cause. */
    public PairException(String message, Throwable cause) {
        super(message, cause);
    }
}
