package org.sami.crw.session;

import java.security.SecureRandom;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.Executor;
import org.sami.boat.link.SteadyClock;
import org.sami.crw.proxy.link.ProxyConfig;
import org.sami.crw.proxy.tcp.TcpBaseConfig;

/** What a session runs on: its time, its threads, and the ways to its boats. */
public sealed interface SessionRuntime {

    /**
     * This machine's time, threads of the session's own, boats behind TCP.
     *
     * @param clock of all timing: the session's time and the timeouts of links
     * @param links timeouts, telemetry rate and client id; no other process that the boats ever meet may have the client id
     * @param front where models live and results arrive: a window gives its event thread; empty = a thread of the session's
     * @param simulatedBoats launches boats for whoever wants simulated ones; empty where nobody may
     */
    record RealTime(
            SteadyClock clock, TcpBaseConfig links, Optional<Executor> front, Optional<SimulatedBoats> simulatedBoats)
            implements SessionRuntime {
        private static final SecureRandom RANDOM = new SecureRandom();

        public RealTime {
            Objects.requireNonNull(clock, "clock");
            Objects.requireNonNull(links, "links");
            Objects.requireNonNull(front, "front");
            Objects.requireNonNull(simulatedBoats, "simulatedBoats");
        }

        /** A runtime on this machine's monotonic clock, with a client id that nobody had before. */
        public static RealTime ofThisProcess() {
            return named(newClientId(), SteadyClock.ofThisMachine());
        }

        /** A runtime with a client id of the caller's. */
        public static RealTime named(String clientId, SteadyClock clock) {
            ProxyConfig proxy =
                    ProxyConfig.DEFAULT.withClientId(clientId).withTelemetryHz(SessionDefaults.TELEMETRY_HZ);
            long jitter = clientId.hashCode(); // bases that begin together do not all come back in one moment
            return new RealTime(clock, TcpBaseConfig.of(proxy, jitter), Optional.empty(), Optional.empty());
        }

        /** A client id that nobody had before. */
        public static String newClientId() {
            return String.format("crw-%012x", RANDOM.nextLong() & 0xffff_ffff_ffffL);
        }

        /** The same with another place for models and results. */
        public RealTime withFront(Executor other) {
            return new RealTime(clock, links, Optional.of(other), simulatedBoats);
        }

        /** The same with somebody who launches simulated boats. */
        public RealTime withSimulatedBoats(SimulatedBoats others) {
            return new RealTime(clock, links, front, Optional.of(others));
        }

        /** The same with other links. */
        public RealTime withLinks(TcpBaseConfig others) {
            return new RealTime(clock, others, front, simulatedBoats);
        }
    }

    /**
     * Everything on one thread of the caller's, who drives it: engine, fleet, models and results.
     *
     * @param clock the session's time
     * @param executor does what it is given on the caller's thread, first in, first out
     */
    record OneThread(Scheduler clock, Executor executor, FleetConnector fleet) implements SessionRuntime {
        public OneThread {
            Objects.requireNonNull(clock, "clock");
            Objects.requireNonNull(executor, "executor");
            Objects.requireNonNull(fleet, "fleet");
        }
    }
}
