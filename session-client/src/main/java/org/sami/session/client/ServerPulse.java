package org.sami.session.client;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Optional;
import java.util.concurrent.TimeUnit;

/** When a session's server was heard last, and how long it may be silent. {@link #heard} from any thread, everything else on the link's. */
final class ServerPulse {
    private static final long SILENT_NANOS = TimeUnit.SECONDS.toNanos(30);

    /** Of a server that sends something twice a second: the lease is over after 3.5 s, the rest is for the other base to open the session. */
    private static final long SILENT_BASE_NANOS = TimeUnit.SECONDS.toNanos(5);

    /** Of such a server that is the only base: where packets are lost, a new connection gets through before one whose repetitions wait ever longer. */
    private static final long SILENT_ONLY_BASE_NANOS = TimeUnit.SECONDS.toNanos(8);

    private static final long QUIET_NANOS = TimeUnit.MILLISECONDS.toNanos(1500);

    private volatile long heardNanos = System.nanoTime();
    private boolean beats; // the server sends something twice a second
    private boolean quiet;

    /** Something came of the server, or is awaited from now on. */
    void heard() {
        heardNanos = System.nanoTime();
    }

    /** A server has let this front in, and says whether it sends something twice a second. */
    void welcomed(JsonNode message) {
        beats = message.path("beat").asLong() > 0;
        quiet = false;
    }

    /**
     * Whether nothing came for so long that the connection is given up.
     *
     * @param welcome whether the server has let this front in
     * @param several whether the session may be at another base
     * @return why, for people; empty where it is not
     */
    Optional<String> lost(boolean welcome, boolean several) {
        long longest = SILENT_NANOS;
        if (beats && welcome) {
            longest = several ? SILENT_BASE_NANOS : SILENT_ONLY_BASE_NANOS;
        }
        return System.nanoTime() - heardNanos > longest
                ? Optional.of("nothing came for " + TimeUnit.NANOSECONDS.toSeconds(longest) + " s")
                : Optional.empty();
    }

    /** Whether a server that has let this front in has become quiet, or is heard again; empty where it is as it was. */
    Optional<Boolean> turned() {
        if (!beats || quiet == System.nanoTime() - heardNanos > QUIET_NANOS) {
            return Optional.empty();
        }
        quiet = !quiet;
        return Optional.of(quiet);
    }
}
