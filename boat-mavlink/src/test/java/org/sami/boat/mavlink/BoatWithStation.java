package org.sami.boat.mavlink;

import java.net.DatagramSocket;
import java.net.InetAddress;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.Executor;
import java.util.function.Function;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.Frame;
import org.sami.boat.link.FrameSink;
import org.sami.boat.link.Hello;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.Role;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.link.Welcome;
import org.sami.boat.server.BoatServer;
import org.sami.boat.server.ServerConfig;
import org.sami.boat.server.ServerSession;
import org.sami.boat.server.tcp.BoatCompanion;
import org.sami.boat.server.tcp.TcpBoatServer;
import org.sami.boat.server.tcp.TcpServerConfig;
import org.sami.boat.server.tcp.TcpServerListener;
import org.sami.boat.server.testing.ProcessClock;

/** A boat that is shown to a ground station on a UDP port of this machine, with a base of ours in its own process. */
final class BoatWithStation implements AutoCloseable {
    static final double LAT = 45.4;
    static final double LON = 10.9;
    private static final double TIMES = 2; // as fast as a real one
    private static final double LONGEST_STEP_S = 0.2; // a busy machine slows it, and does not throw it about
    private static final long PATIENCE_MS = 60_000; // a ground station that has no processor for seconds is not lost

    final int port;
    private final TcpBoatServer server;
    private final GroundStationLink link;
    private final Base base = new Base();
    private long lastMs;

    /** A boat that does not take a slow station for a lost one. */
    static BoatWithStation patient() throws Exception {
        return new BoatWithStation(ServerConfig.of("anna", "boot1")
                .lostLinkAction(LostLinkAction.HOLD)
                .lostLinkAfterMs(PATIENCE_MS)
                .build());
    }

    /** A boat that does something for a lost link after as long as any boat does. */
    static BoatWithStation losingIts(LostLinkAction lostLink) throws Exception {
        return new BoatWithStation(
                ServerConfig.of("anna", "boot1").lostLinkAction(lostLink).build());
    }

    private BoatWithStation(ServerConfig config) throws Exception {
        try (DatagramSocket free = new DatagramSocket(0, InetAddress.getLoopbackAddress())) {
            port = free.getLocalPort();
        }
        DrivenHull hull = new DrivenHull(LAT, LON);
        BoatServer boat = new BoatServer(config, hull);
        SteadyClock clock = new SteadyClock(ProcessClock::ms);
        server = new TcpBoatServer(
                "anna",
                boat,
                TcpServerConfig.onLoopback(0),
                clock,
                now -> {
                    hull.move(lastMs == 0 ? 0 : Math.min(LONGEST_STEP_S, (now - lastMs) / 1000.0) * TIMES);
                    lastMs = now;
                },
                TcpServerListener.NONE);
        server.start();
        link = new GroundStationLink("anna", 7, StationAddress.parse("udp:127.0.0.1:" + port), clock);
        server.attach(link);
        server.attach(base);
    }

    /** The base, which observes at first. */
    Base base() {
        return base;
    }

    GroundStationLink link() {
        return link;
    }

    @Override
    public void close() throws Exception {
        server.close();
        link.close();
    }

    /** A base of ours. */
    static final class Base implements BoatCompanion, FrameSink {
        final List<LinkMessage> heard = new CopyOnWriteArrayList<>();
        private final CompletableFuture<Executor> thread = new CompletableFuture<>();
        private ServerSession session;
        private BoatServer boat;
        private long nowMs;
        private long sequence;
        private long commands;
        private String term = "";

        @Override
        public void begin(BoatServer server, Executor boatThread, long now) {
            boat = server;
            nowMs = now;
            session = server.connect(this);
            thread.complete(boatThread);
        }

        @Override
        public void tick(long now) {
            nowMs = now;
            if (session.role().equals(Optional.of(Role.COMMANDER))) {
                say(new org.sami.boat.link.Heartbeat(now));
            }
        }

        @Override
        public void end(long now) {
            session.closed(now);
        }

        private void say(LinkMessage message) {
            session.receive(new Frame(sequence++, term, message), nowMs);
        }

        private <T> T ask(java.util.function.Supplier<T> what) {
            return CompletableFuture.supplyAsync(what, thread.join()).join();
        }

        void command(Role role) {
            ask(() -> {
                say(new Hello("", "base1", role, 1, "", "session1", 5));
                return role;
            });
        }

        void send(Function<String, CommandMessage> command) {
            ask(() -> {
                say(command.apply("b" + ++commands));
                return commands;
            });
        }

        BoatMode mode() {
            return ask(() -> boat.mode());
        }

        Optional<String> commandedBy() {
            return ask(() -> boat.commandedBy());
        }

        @Override
        public void send(byte[] frame) {
            throw new IllegalStateException();
        }

        @Override
        public void send(Frame frame) {
            if (frame.message() instanceof Welcome welcome) {
                term = welcome.term();
            }
            heard.add(frame.message());
        }
    }
}
