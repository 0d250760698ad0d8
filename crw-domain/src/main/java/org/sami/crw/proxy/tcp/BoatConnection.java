package org.sami.crw.proxy.tcp;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.UnknownHostException;
import java.util.Optional;
import org.sami.boat.link.FramePump;
import org.sami.boat.link.FrameSink;
import org.sami.boat.link.FrameThreads;
import org.sami.boat.link.LinkException;
import org.sami.boat.link.security.Fingerprint;
import org.sami.boat.link.security.SecureLink;

/**
 * One connection to a boat, from the try to connect to its end: a thread that connects and reads, and one that writes. What is
 * sent waits in a bounded queue, so that nobody ever waits for a boat; a boat that sends more than the base takes waits itself.
 */
final class BoatConnection implements FrameSink {
    private static final int SEND_BUFFER_BYTES = 64 << 10;

    /** Where a connection hands what happens; called on the connection's threads. */
    interface Owner {
        /** It stands. */
        void opened(BoatConnection connection);

        /** A whole frame has come; {@code done} is to be run once it has been taken. */
        void arrived(BoatConnection from, byte[] frame, Runnable done);

        /** It is closed or could not be had, for a reason in words. Called once. */
        void closed(BoatConnection connection, String why);
    }

    private final InetSocketAddress address;
    private final TcpBaseConfig config;
    private final Owner owner;
    private final Socket socket = new Socket();
    private volatile Optional<SecureLink> link = Optional.empty(); // once it stands
    private final FramePump pump;
    private final ExcessFrames excess = new ExcessFrames(() -> System.nanoTime() / 1_000_000);
    private final FrameThreads threads;

    BoatConnection(InetSocketAddress address, TcpBaseConfig config, Owner owner) {
        this.address = address;
        this.config = config;
        this.owner = owner;
        pump = new FramePump(config.maxQueuedFrames(), config.maxQueuedBytes());
        String name = config.proxy().clientId() + "-to-" + address.getHostString() + ":" + address.getPort();
        threads = new FrameThreads(pump, socket, name, this::read, this::write);
    }

    /** Begins to connect. */
    void start() {
        threads.startReading();
    }

    @Override
    public void send(byte[] frame) {
        if (!pump.send(frame)) {
            close("the boat does not take what it is sent");
        }
    }

    /** The boat's key; empty while there is no link, and on a plain one. */
    Optional<Fingerprint> peer() {
        return link.flatMap(SecureLink::peer);
    }

    /** How many frames were left out, as too many came, since this was asked last. */
    long takeLeftOut() {
        return excess.takeLeftOut();
    }

    /** Closes the socket, which ends both threads. */
    void close(String why) {
        if (threads.close()) {
            owner.closed(this, why);
        }
    }

    /** Waits until both threads have ended, after {@link #close}; not for these threads themselves. */
    void join(long millis) throws InterruptedException {
        threads.join(millis);
    }

    private void read() {
        try {
            socket.setTcpNoDelay(true);
            socket.setSendBufferSize(SEND_BUFFER_BYTES);
            InetSocketAddress resolved = address.isUnresolved() // the name may lead elsewhere than at the last try
                    ? new InetSocketAddress(address.getHostString(), address.getPort())
                    : address;
            socket.connect(resolved, config.connectWithinMs());
            socket.setSoTimeout(config.connectWithinMs());
            SecureLink standing = config.security().connect(socket);
            socket.setSoTimeout(0);
            link = Optional.of(standing);
            owner.opened(this);
            threads.startWriting();
            pump.read(standing.in(), (frame, done) -> {
                if (excess.isExcess(frame)) {
                    done.run();
                } else {
                    owner.arrived(this, frame, done);
                }
            });
            close("the boat has closed the link");
        } catch (LinkException e) {
            close("the boat sends what is no frame: " + e.getMessage());
        } catch (UnknownHostException e) {
            close("there is no host " + address.getHostString());
        } catch (IOException | InterruptedException e) {
            close(e.getMessage() == null ? e.toString() : e.getMessage());
        }
    }

    private void write() {
        try {
            pump.write(link.orElseThrow().out());
        } catch (IOException | InterruptedException e) {
            close("the link broke: " + e.getMessage());
        }
    }
}
