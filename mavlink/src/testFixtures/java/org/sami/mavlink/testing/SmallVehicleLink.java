package org.sami.mavlink.testing;

import io.dronefleet.mavlink.Mavlink2Message;
import io.dronefleet.mavlink.MavlinkConnection;
import io.dronefleet.mavlink.MavlinkMessage;
import io.dronefleet.mavlink.minimal.Heartbeat;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.time.Instant;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.sami.mavlink.link.LinkSigning;
import org.sami.mavlink.link.SigningKey;

/** The port of a small vehicle, on TCP on loopback, with one client at a time. Safe for use by several threads. */
final class SmallVehicleLink implements AutoCloseable {
    private static final int AUTOPILOT = 1;

    private final int system;
    private final BooleanSupplier isCut;
    private final Consumer<Object> taking;
    private final ServerSocket server;
    private Optional<LinkSigning> signing = Optional.empty();
    private Socket client = new Socket();
    private MavlinkConnection codec;
    private boolean firstVersion;
    private Optional<SmallVehicleLink> passedTo = Optional.empty(); // heartbeats of ground stations

    /**
     * Listens.
     *
     * @param port 0 for a free one
     * @param isCut whether new clients are turned away
     * @param taking receives the messages of the client, on the link's thread
     */
    SmallVehicleLink(int system, int port, BooleanSupplier isCut, Consumer<Object> taking) throws IOException {
        this.system = system;
        this.isCut = isCut;
        this.taking = taking;
        server = new ServerSocket();
        server.bind(new InetSocketAddress(InetAddress.getLoopbackAddress(), port), 1);
    }

    /** The port on which it listens. */
    int port() {
        return server.getLocalPort();
    }

    /** Passes the heartbeats of its client on to the client of another link, as ArduPilot does; to be called before {@link #start}. */
    void passHeartbeatsTo(SmallVehicleLink other) {
        passedTo = Optional.of(other);
    }

    private void passOn(MavlinkMessage<?> heartbeat) {
        passedTo.ifPresent(other -> other.pass(heartbeat));
    }

    private synchronized void pass(MavlinkMessage<?> heartbeat) {
        if (codec != null) {
            try {
                codec.send2(heartbeat.getOriginSystemId(), heartbeat.getOriginComponentId(), heartbeat.getPayload());
            } catch (IOException e) {
                // its reading thread finds out
            }
        }
    }

    /** Begins to serve clients. */
    void start() {
        Thread thread = new Thread(this::serve, "small vehicle " + system);
        thread.setDaemon(true);
        thread.start();
    }

    /** Its address for a base. */
    String address() {
        return "mavlink:tcp:127.0.0.1:" + server.getLocalPort();
    }

    /** Ignores what is not signed with a key, and signs with it, as ArduPilot does on all ports but the first. */
    synchronized void keyed(SigningKey fleet) {
        signing = Optional.of(new LinkSigning(fleet, Instant::now, LinkSigning.Unsigned.REFUSED));
    }

    /** Speaks MAVLink 1 from now on. */
    synchronized void speakFirstVersion() {
        firstVersion = true;
    }

    private synchronized boolean takes(MavlinkMessage<?> message) {
        if (signing.isEmpty()) {
            return true;
        }
        byte[] secret = signing.get().key().secret();
        return message instanceof Mavlink2Message<?> second && second.isSigned() && second.validateSignature(secret);
    }

    private void serve() {
        while (!server.isClosed()) {
            try (Socket socket = server.accept()) {
                if (isCut.getAsBoolean()) {
                    continue;
                }
                socket.setTcpNoDelay(true);
                MavlinkConnection open = MavlinkConnection.create(socket.getInputStream(), socket.getOutputStream());
                synchronized (this) {
                    client = socket;
                    codec = open;
                }
                for (MavlinkMessage<?> message = open.next(); message != null; message = open.next()) {
                    if (message.getPayload() instanceof Heartbeat) {
                        passOn(message);
                    }
                    if (takes(message)) {
                        taking.accept(message.getPayload());
                    }
                }
            } catch (IOException e) {
                // this client is gone; the next may come
            }
        }
    }

    /** Sends a message to the client, if there is one. */
    synchronized void send(Object payload) {
        if (codec != null) {
            try {
                if (signing.isPresent()) {
                    LinkSigning by = signing.get();
                    codec.send2(
                            system,
                            AUTOPILOT,
                            payload,
                            0,
                            by.nextTime(),
                            by.key().secret());
                } else if (firstVersion) {
                    codec.send1(system, AUTOPILOT, payload);
                } else {
                    codec.send2(system, AUTOPILOT, payload);
                }
            } catch (IOException e) {
                // its reading thread finds out
            }
        }
    }

    /** Cuts the client off. */
    synchronized void cut() throws IOException {
        client.close();
    }

    /** Ends it: its port is free, and its client is cut off. */
    @Override
    public void close() throws IOException {
        server.close();
        cut();
    }
}
