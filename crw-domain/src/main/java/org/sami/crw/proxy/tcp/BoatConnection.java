package org.sami.crw.proxy.tcp;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.UnknownHostException;
import java.util.Optional;
import java.util.concurrent.Semaphore;
import java.util.concurrent.atomic.AtomicBoolean;
import org.sami.boat.link.FrameQueue;
import org.sami.boat.link.FrameReader;
import org.sami.boat.link.FrameSink;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkException;

/**
 * One connection to a boat, from the try to connect to its end: a thread that connects and reads, and one that writes. What is
 * sent waits in a bounded queue, so that nobody ever waits for a boat; a boat that sends more than the base takes waits itself.
 */
final class BoatConnection implements FrameSink {
    private static final int MAX_UNREAD_BYTES = 2 * LinkCodec.DEFAULT_MAX_BYTES;
    private static final int LEAST_UNREAD_BYTES = MAX_UNREAD_BYTES / 64; // so that not many small frames wait either
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
    private final FrameQueue queue;
    private final Semaphore unread = new Semaphore(MAX_UNREAD_BYTES);
    private final AtomicBoolean closed = new AtomicBoolean();
    private final Thread reader;
    private final Thread writer;

    BoatConnection(InetSocketAddress address, TcpBaseConfig config, Owner owner) {
        this.address = address;
        this.config = config;
        this.owner = owner;
        queue = new FrameQueue(config.maxQueuedFrames(), config.maxQueuedBytes());
        String name = config.proxy().clientId() + "-to-" + address.getHostString() + ":" + address.getPort();
        reader = thread(this::read, name + "-reads");
        writer = thread(this::write, name + "-writes");
    }

    private static Thread thread(Runnable work, String name) {
        Thread thread = new Thread(work, name);
        thread.setDaemon(true);
        return thread;
    }

    /** Begins to connect. */
    void start() {
        reader.start();
    }

    @Override
    public void send(byte[] frame) {
        if (!queue.offer(frame)) {
            close("the boat does not take what it is sent");
        }
    }

    /** Closes the socket, which ends both threads. */
    void close(String why) {
        if (closed.compareAndSet(false, true)) {
            queue.close();
            try {
                socket.close();
            } catch (IOException e) {
                // it is closed for us all the same
            }
            reader.interrupt(); // it may wait for the base
            owner.closed(this, why);
        }
    }

    /** Waits until both threads have ended, after {@link #close}; not for these threads themselves. */
    void join(long millis) throws InterruptedException {
        reader.join(millis);
        writer.join(millis);
    }

    private void read() {
        try {
            socket.setTcpNoDelay(true);
            socket.setSendBufferSize(SEND_BUFFER_BYTES);
            InetSocketAddress resolved = address.isUnresolved() // the name may lead elsewhere than at the last try
                    ? new InetSocketAddress(address.getHostString(), address.getPort())
                    : address;
            socket.connect(resolved, config.connectWithinMs());
            owner.opened(this);
            writer.start();
            FrameReader frames = new FrameReader(new BufferedInputStream(socket.getInputStream()), new LinkCodec());
            for (Optional<byte[]> next = frames.next(); next.isPresent(); next = frames.next()) {
                int counted = Math.max(LEAST_UNREAD_BYTES, next.get().length);
                unread.acquire(counted);
                owner.arrived(this, next.get(), () -> unread.release(counted));
            }
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
            OutputStream out = new BufferedOutputStream(socket.getOutputStream());
            for (Optional<byte[]> next = queue.take(); next.isPresent(); next = queue.take()) {
                out.write(next.get());
                if (queue.isEmpty()) {
                    out.flush();
                }
            }
        } catch (IOException | InterruptedException e) {
            close("the link broke: " + e.getMessage());
        }
    }
}
