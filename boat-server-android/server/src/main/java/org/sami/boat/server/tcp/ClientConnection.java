package org.sami.boat.server.tcp;

import java.io.IOException;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.util.Optional;
import org.sami.boat.link.Frame;
import org.sami.boat.link.FramePump;
import org.sami.boat.link.FrameSink;
import org.sami.boat.link.FrameThreads;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkException;
import org.sami.boat.link.security.Fingerprint;
import org.sami.boat.link.security.LinkRefusedException;
import org.sami.boat.link.security.LinkSecurity;
import org.sami.boat.link.security.SecureLink;

/**
 * One client's socket, with a reading and a writing thread. The boat's messages wait in a bounded queue: the boat never waits for a client. The client's
 * frames are passed on while the boat keeps up; otherwise the client waits.
 */
final class ClientConnection implements FrameSink {
    private static final int SEND_BUFFER_BYTES = 64 << 10; // so that it is the pump that shows how slow a client is

    /** Receives the events of a connection, on the connection's threads. */
    interface Owner {
        /** The link is protected, and that is the client's key. Called before any frame. */
        void secured(ClientConnection connection, Fingerprint key);

        /** The link could not be protected, for a reason in words; {@code closed} follows. */
        void notSecured(ClientConnection connection, String why);

        /** A whole frame has come; {@code done} is to be run once the boat has taken it. */
        void arrived(ClientConnection from, byte[] frame, Runnable done);

        /** The connection is closed, for a reason in words. Called once. */
        void closed(ClientConnection connection, String why);
    }

    private final Socket socket;
    private final Owner owner;
    private final String name;
    private final long number;
    private final LinkSecurity security;
    private final FramePump pump;
    private volatile Optional<SecureLink> link = Optional.empty(); // once both sides are known to each other
    private volatile Optional<String> leaving = Optional.empty(); // why it is closed once all is sent
    private final FrameThreads threads;

    /** A client's socket; the numbers of connections grow. */
    ClientConnection(Socket socket, long number, TcpServerConfig config, String boatId, Owner owner)
            throws IOException {
        this.socket = socket;
        this.number = number;
        this.owner = owner;
        name = socket.getRemoteSocketAddress().toString();
        socket.setTcpNoDelay(true);
        socket.setSendBufferSize(SEND_BUFFER_BYTES);
        socket.setSoTimeout(config.silentAfterMs());
        pump = new FramePump(config.maxQueuedFrames(), config.maxQueuedBytes());
        security = config.security();
        threads = new FrameThreads(pump, socket, boatId + "-from-" + name, this::read, this::write);
    }

    /** Begins to read and write. */
    void start() {
        threads.startReading();
    }

    /** The client's address, for people. */
    String name() {
        return name;
    }

    /** Grows with each connection. */
    long number() {
        return number;
    }

    @Override
    public void send(byte[] frame) {
        if (!pump.send(frame)) {
            close("it does not take what it is sent");
        }
    }

    @Override
    public boolean sendBelow(Frame frame) {
        return pump.sendBelow(LinkCodec.STANDARD.encode(frame));
    }

    /** Closes the socket, which ends both threads. */
    void close(String why) {
        if (threads.close()) {
            owner.closed(this, leaving.orElse(why));
        }
    }

    /** Sends nothing more, and closes the socket when what waits has been written. */
    void closeOnceSent(String why) {
        leaving = Optional.of(why);
        pump.finish();
    }

    /** Waits until both threads have ended, after {@link #close}; not for these threads themselves. */
    void join(long millis) throws InterruptedException {
        threads.join(millis);
    }

    private void read() {
        try {
            SecureLink standing = security.accept(socket);
            link = Optional.of(standing);
            standing.peer().ifPresent(key -> owner.secured(this, key));
            threads.startWriting();
            pump.read(standing.in(), (frame, done) -> owner.arrived(this, frame, done));
            close("it has closed the link");
        } catch (LinkException e) {
            close("it sends what is no frame: " + e.getMessage());
        } catch (LinkRefusedException e) {
            owner.notSecured(this, String.valueOf(e.getMessage()));
            close(String.valueOf(e.getMessage()));
        } catch (SocketTimeoutException e) {
            close("it has been silent for too long");
        } catch (IOException | InterruptedException e) {
            close("the link broke: " + e.getMessage());
        }
    }

    private void write() {
        try {
            pump.write(link.get().out());
            leaving.ifPresent(this::close);
        } catch (IOException | InterruptedException e) {
            close("the link broke: " + e.getMessage());
        }
    }
}
