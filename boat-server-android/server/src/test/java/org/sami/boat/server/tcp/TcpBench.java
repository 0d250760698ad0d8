package org.sami.boat.server.tcp;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.UnaryOperator;
import org.sami.boat.link.Frame;
import org.sami.boat.link.FrameReader;
import org.sami.boat.link.Hello;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkException;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Role;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.link.Telemetry;
import org.sami.boat.link.Welcome;
import org.sami.boat.link.security.KeyRing;
import org.sami.boat.link.security.LinkSecurity;
import org.sami.boat.link.security.OpenLinks;
import org.sami.boat.link.security.PairingResponder;
import org.sami.boat.link.security.Peer;
import org.sami.boat.link.security.SecureLink;
import org.sami.boat.link.security.TlsLinks;
import org.sami.boat.server.BoatServer;
import org.sami.boat.server.ServerConfig;
import org.sami.boat.server.vehicle.Vehicle;

/**
 * A boat that lies still behind a real port of the loopback address, and clients of it.
 *
 * <p>The boat's time is counted in its ticks, so that a machine that stands still for a while changes nothing; a test may let
 * more of it pass, or take it over.
 */
final class TcpBench implements AutoCloseable {
    private static final AtomicLong NAMES = new AtomicLong();
    private static final int LONG_MS = 600_000; // of the machine's time: no test is about it

    /** With which the names of its threads begin, and of no others'. */
    final String name;

    final List<String> executed = java.util.Collections.synchronizedList(new ArrayList<>());
    final ConcurrentLinkedQueue<String> failures = new ConcurrentLinkedQueue<>();
    final ConcurrentLinkedQueue<String> goodbyes = new ConcurrentLinkedQueue<>();
    final TcpBoatServer server;
    volatile Runnable duringTick = () -> {};
    private final LinkSecurity ofClients;
    private final AtomicLong timeMs = new AtomicLong();
    private final List<Client> clients = new ArrayList<>();
    private volatile boolean ticksCount = true;

    TcpBench() throws IOException {
        this(UnaryOperator.identity(), UnaryOperator.identity());
    }

    TcpBench(UnaryOperator<ServerConfig.Builder> boat, UnaryOperator<TcpServerConfig> tcp) throws IOException {
        this("bench%04d".formatted(NAMES.incrementAndGet()), boat, tcp);
    }

    TcpBench(String name, UnaryOperator<ServerConfig.Builder> boat, UnaryOperator<TcpServerConfig> tcp)
            throws IOException {
        this(name, boat, tcp, new OpenLinks());
    }

    private TcpBench(
            String name,
            UnaryOperator<ServerConfig.Builder> boat,
            UnaryOperator<TcpServerConfig> tcp,
            LinkSecurity ofClients)
            throws IOException {
        this.name = name;
        this.ofClients = ofClients;
        BoatServer boatServer = new BoatServer(
                boat.apply(ServerConfig.of("boat1", "boot1")).build(),
                new Moored(),
                (nowMs, client, command, answer) -> executed.add(command.commandId() + " " + answer.type()));
        TcpServerConfig config = tcp.apply(TcpServerConfig.onLoopback(0).withPatience(LONG_MS, LONG_MS));
        server = new TcpBoatServer(
                name,
                boatServer,
                config,
                new SteadyClock(timeMs::get),
                nowMs -> {
                    duringTick.run();
                    if (ticksCount) {
                        timeMs.addAndGet(config.tickMs());
                    }
                },
                new TcpServerListener() {
                    @Override
                    public void closed(String client, String why) {
                        goodbyes.add(why);
                    }

                    @Override
                    public void failed(String what, Throwable cause) {
                        failures.add(what + ": " + cause);
                    }
                });
        server.start();
    }

    /** The same over protected links: the boat obeys the one key that all clients have. */
    static TcpBench overTls(UnaryOperator<ServerConfig.Builder> boat, UnaryOperator<TcpServerConfig> tcp)
            throws IOException {
        KeyRing ofBoat = KeyRing.inMemory();
        KeyRing ofClients = KeyRing.inMemory();
        ofBoat.add(new Peer(ofClients.identity().fingerprint(), "clients", Role.COMMANDER));
        return new TcpBench(
                "bench%04d".formatted(NAMES.incrementAndGet()),
                boat,
                plain -> tcp.apply(plain.withKeys(ofBoat, new PairingResponder(ofBoat))),
                TlsLinks.toPair(ofClients.identity()));
    }

    /** From now on the boat's time passes only by {@link #passMs}. */
    TcpBench stopTime() {
        ticksCount = false;
        return this;
    }

    /** The source of the boat's time, in ms since the server began. */
    long timeMs() {
        return timeMs.get();
    }

    /** Sets the source of the boat's time forward, or back. */
    void passMs(long ms) {
        timeMs.addAndGet(ms);
    }

    /** The telemetry that a client gets next after a tenth of a second of the boat's time, which stands otherwise. */
    Telemetry nextOf(Client client) throws Exception {
        passMs(100);
        return client.await(Telemetry.class);
    }

    Client connect() throws IOException {
        Client client = new Client(server.address(), ofClients);
        clients.add(client);
        return client;
    }

    Client greet(String clientId, Role role, double telemetryHz) throws Exception {
        Client client = connect();
        client.say(new Hello("boat1", clientId, role, telemetryHz, ""));
        client.await(Welcome.class);
        return client;
    }

    /** Whether the boat has seen that a client closed its socket, which is a reset where the client had not read all. */
    boolean hasSeenOneGo() {
        return goodbyes.stream()
                .anyMatch(why -> why.equals("it has closed the link") || why.startsWith("the link broke"));
    }

    void closeClients() throws IOException {
        for (Client client : clients) {
            client.close();
        }
    }

    /** What the threads that read from clients have taken of the heap so far. */
    long bytesAllocatedByReaders() {
        com.sun.management.ThreadMXBean threads = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
        return Thread.getAllStackTraces().keySet().stream()
                .filter(thread -> thread.getName().startsWith(name + "-from-")
                        && thread.getName().endsWith("-reads"))
                .mapToLong(thread -> threads.getThreadAllocatedBytes(thread.getId()))
                .sum();
    }

    @Override
    public void close() throws IOException {
        closeClients();
        server.close();
    }

    /** A client on a socket, for one thread. */
    static final class Client implements AutoCloseable {
        private static final int PATIENCE_MS = 60_000;
        final Socket socket = new Socket();
        private final LinkCodec codec = new LinkCodec();
        private final SecureLink link;
        private final FrameReader frames;
        private long sequence;
        private String term = "";

        Client(InetSocketAddress address, LinkSecurity security) throws IOException {
            socket.setReceiveBufferSize(16 << 10);
            socket.setTcpNoDelay(true);
            socket.setSoTimeout(PATIENCE_MS);
            socket.connect(address, PATIENCE_MS);
            link = security.connect(socket);
            frames = new FrameReader(new BufferedInputStream(link.in()), codec);
        }

        void say(LinkMessage message) throws IOException {
            send(frame(sequence++, message));
        }

        /** A frame as this client would send it now. */
        byte[] frame(long asSequence, LinkMessage message) {
            return codec.encode(new Frame(asSequence, term, message));
        }

        void send(byte[] bytes) throws IOException {
            link.out().write(bytes);
        }

        /** The next frame, whatever is in it. */
        byte[] nextFrame() throws IOException, LinkException {
            return frames.next().orElseThrow(() -> new IOException("the boat has closed the link"));
        }

        /** The next message of a kind; others before it are read and forgotten. */
        <M extends LinkMessage> M await(Class<M> kind) throws IOException, LinkException {
            while (true) {
                Frame frame = codec.decode(nextFrame());
                if (frame.message() instanceof Welcome welcome) {
                    term = welcome.term();
                }
                if (kind.isInstance(frame.message())) {
                    return kind.cast(frame.message());
                }
            }
        }

        /** Whether the boat closes this link, whatever it says before. */
        boolean isClosedByTheBoat() {
            try {
                while (frames.next().isPresent()) {
                    // reads on
                }
                return true;
            } catch (java.net.SocketTimeoutException e) {
                return false;
            } catch (IOException | LinkException e) {
                return true;
            }
        }

        @Override
        public void close() throws IOException {
            socket.close();
        }
    }

    /** A boat that lies still. */
    private static final class Moored implements Vehicle {
        @Override
        public double latDeg() {
            return 45;
        }

        @Override
        public double lonDeg() {
            return 10;
        }

        @Override
        public double headingRad() {
            return 0;
        }

        @Override
        public double speedMps() {
            return 0;
        }

        @Override
        public double batteryPercent() {
            return 100;
        }

        @Override
        public void setMotors(double port, double starboard) {}
    }
}
