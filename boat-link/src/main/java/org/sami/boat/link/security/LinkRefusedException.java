package org.sami.boat.link.security;

import java.io.IOException;

/** A connection is refused before anything is said over it; the message is one line for people. */
public final class LinkRefusedException extends IOException {
    private static final long serialVersionUID = 1;

    /** Refused for a reason in words. */
    public LinkRefusedException(String reason, Throwable cause) {
        super(reason, cause);
    }

    /** Refused for a reason in words. */
    public LinkRefusedException(String reason) {
        super(reason);
    }
}
