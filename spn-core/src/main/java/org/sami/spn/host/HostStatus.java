package org.sami.spn.host;

import java.util.Objects;

/**
 * Whether a host works.
 *
 * @param reason why not, one sentence in plain words; empty text while it runs
 * @param details where it is so, and the words of the machine, for those who mend it; empty text for none
 */
public record HostStatus(Kind kind, String reason, String details) {
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
        Objects.requireNonNull(details, "details");
    }

    /** Without details. */
    public HostStatus(Kind kind, String reason) {
        this(kind, reason, "");
    }

    /** The reason with its details, such as {@code the journal cannot be written: the disk is full (lake.journal, entry 91)}. */
    public String whole() {
        return details.isEmpty() ? reason : reason + " (" + details + ")";
    }

    /** It has stopped for the same reason, with further details. */
    HostStatus failed(String more) {
        return new HostStatus(Kind.FAILED, reason + "; " + more, details);
    }

    /** Whether it takes inputs in, now or later. */
    public boolean isAlive() {
        return kind == Kind.RUNNING || kind == Kind.WAITING;
    }

    static HostStatus running() {
        return new HostStatus(Kind.RUNNING, "");
    }
}
