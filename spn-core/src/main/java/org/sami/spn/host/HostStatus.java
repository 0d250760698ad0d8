package org.sami.spn.host;

import java.util.Objects;

/**
 * Whether a host works.
 *
 * @param reason one sentence; empty text while it runs
 */
public record HostStatus(Kind kind, String reason) {
    /** How it stands. */
    public enum Kind {
        RUNNING,
        /** Closed in order: all that was taken in was processed. */
        CLOSED,
        /** Stopped by a fault: nothing that was not durable has left, nothing more is taken in. */
        FAILED
    }

    public HostStatus {
        Objects.requireNonNull(kind, "kind");
        Objects.requireNonNull(reason, "reason");
    }

    static HostStatus running() {
        return new HostStatus(Kind.RUNNING, "");
    }
}
