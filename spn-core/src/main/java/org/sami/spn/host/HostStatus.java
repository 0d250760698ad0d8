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
        /** Its journal cannot be written: nothing is let out, what is posted waits, and it goes on by itself once the journal can be. */
        WAITING,
        /** Closed in order: all that was taken in was processed. */
        CLOSED,
        /** Stopped by a fault: nothing that was not durable has left, nothing more is taken in. */
        FAILED
    }

    public HostStatus {
        Objects.requireNonNull(kind, "kind");
        Objects.requireNonNull(reason, "reason");
    }

    /** Whether it takes inputs in, now or later. */
    public boolean isAlive() {
        return kind == Kind.RUNNING || kind == Kind.WAITING;
    }

    static HostStatus running() {
        return new HostStatus(Kind.RUNNING, "");
    }
}
