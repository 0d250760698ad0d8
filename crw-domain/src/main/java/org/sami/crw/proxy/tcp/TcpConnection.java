package org.sami.crw.proxy.tcp;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.UnknownHostException;
import java.util.Optional;
import org.sami.boat.link.FramePump;
import org.sami.boat.link.FrameThreads;
import org.sami.boat.link.LinkException;
import org.sami.boat.link.security.Fingerprint;
import org.sami.boat.link.security.SecureLink;

/**
 * One TCP connection to a boat, from the try to connect to its end: a thread that connects and reads, and one that writes. What is
 * sent waits in a bounded queue, so that nobody ever waits for a boat; a boat that sends more than the base takes waits itself.
 */
final class TcpConnection implements BoatConnection {
    private static final int SEND_BUFFER_BYTES = 64 << 10;

    private final InetSocketAddress address;
    private final TcpBaseConfig config;
    private final Owner owner;
    private final Socket socket = new Socket();
    private volatile Optional<SecureLink> link = Optional.empty(); // once it stands
    private final FramePump pump;
    private final ExcessFrames excess = new ExcessFrames(() -> System.nanoTime() / 1_000_000);
    private final FrameThreads threads;

    TcpConnection(InetSocketAddress address, TcpBaseConfig config, Owner owner) {
        this.address = address;
        this.config = config;
        this.owner = owner;
        pump = new FramePump(config.maxQueuedFrames(), config.maxQueuedBytes());
        String name = config.proxy().clientId() + "-to-" + address.getHostString() + ":" + address.getPort();
        threads = new FrameThreads(pump, socket, name, this::read, this::write);
    }

    @Override
    public void start() {
        threads.startReading();
    }

    @Override
    public void send(byte[] frame) {
        if (!pump.send(frame)) {
            close("the boat does not take what it is sent");
        }
    }

    @Override
    public Optional<Fingerprint> peer() {
        return link.flatMap(SecureLink::peer);
    }

    @Override
    public long takeLeftOut() {
        return excess.takeLeftOut();
    }

    /** Closes the socket, which ends both threads. */
    @Override
    public void close(String why) {
        if (threads.close()) {
            owner.closed(this, why);
        }
    }

    @Override
    public void join(long millis) throws InterruptedException {
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
