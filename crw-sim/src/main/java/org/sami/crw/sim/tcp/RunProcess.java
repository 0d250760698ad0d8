package org.sami.crw.sim.tcp;

import java.security.SecureRandom;
import java.util.Objects;
import org.sami.boat.link.SteadyClock;

/**
 * What one process of a run behind TCP brings with it; everything about it that is neither plan nor setting.
 *
 * @param clock of all timing in it: the session's time, timeouts of links, waiting
 * @param clientId names this process to boats, and its waypoint lists; never used by another process that they meet
 * @param connectWithinMillis how long boats may take to answer at the start
 */
public record RunProcess(SteadyClock clock, String clientId, long connectWithinMillis) {
    private static final SecureRandom RANDOM = new SecureRandom();

    public RunProcess {
        Objects.requireNonNull(clock, "clock");
        if (clientId.isEmpty() || connectWithinMillis < 0) {
            throw new IllegalArgumentException(
                    "client '" + clientId + "', to be connected within " + connectWithinMillis + " ms");
        }
    }

    /** A process on this machine's monotonic clock, with a name that nobody had before. */
    public static RunProcess ofThisProcess(long connectWithinMillis) {
        String clientId = String.format("crw-%012x", RANDOM.nextLong() & 0xffff_ffff_ffffL);
        return new RunProcess(SteadyClock.ofThisMachine(), clientId, connectWithinMillis);
    }
}
