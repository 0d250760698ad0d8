package org.sami.spn.host;

import java.io.IOException;
import java.util.OptionalLong;

/** How long, and with how much, a host waits for a journal that cannot be written. For who holds the host's lock, but for its limit of inputs. */
final class JournalRetryPolicy {
    /** A full disk is looked at again after so long. */
    static final long RETRY_MILLIS = 1000;

    /** Boats that stand still say little: what is more comes of a fault, and would fill the memory. */
    private static final int MOST_INPUTS = 100_000;

    private final long millis;
    private OptionalLong sinceMillis = OptionalLong.empty();

    /** @param millis how long it waits */
    JournalRetryPolicy(long millis) {
        this.millis = millis;
    }

    /** How many inputs may wait meanwhile. */
    int inputs() {
        return MOST_INPUTS;
    }

    /**
     * How a host stands whose journal cannot be written now.
     *
     * @param isRecoverable whether the journal may be written again
     */
    HostStatus after(IOException fault, boolean isRecoverable, long nowMillis) {
        HostStatus waiting = status(HostStatus.Kind.WAITING, fault);
        if (!isRecoverable) {
            return status(HostStatus.Kind.FAILED, fault);
        }
        if (sinceMillis.isEmpty()) {
            sinceMillis = OptionalLong.of(nowMillis);
        }
        return nowMillis - sinceMillis.getAsLong() < millis
                ? waiting
                : waiting.failed("it could not be written for " + millis / 1000 + " s");
    }

    /** How a host stands whose journal failed: the reason in plain words, then where, and what the machine says. */
    static HostStatus status(HostStatus.Kind kind, IOException fault) {
        return fault instanceof JournalException known
                ? new HostStatus(kind, known.reason(), known.details())
                : new HostStatus(kind, "the journal cannot be written: " + fault.getMessage());
    }

    /** It can be written again. */
    void recovered() {
        sinceMillis = OptionalLong.empty();
    }
}
