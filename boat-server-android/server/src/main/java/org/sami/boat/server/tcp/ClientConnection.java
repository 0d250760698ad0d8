package org.sami.boat.server.tcp;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.util.Optional;
import java.util.concurrent.Semaphore;
import java.util.concurrent.atomic.AtomicBoolean;
import org.sami.boat.link.FrameQueue;
import org.sami.boat.link.FrameReader;
import org.sami.boat.link.FrameSink;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkException;

/**
 * One client's socket, with a thread that reads and one that writes. What the boat sends waits in a bounded queue: the boat
 * never waits for a client. What the client sends is handed on as long as the boat keeps up; then the client waits.
 */
final class ClientConnection implements FrameSink {
    /** Bytes of one client that may wait for the boat: more than the largest frame. */
    private static final int MAX_UNREAD_BYTES = 2 * LinkCodec.DEFAULT_MAX_BYTES;

    /** What a frame counts for at least: so that not many small ones wait either. */
    private static final int LEAST_UNREAD_BYTES = MAX_UNREAD_BYTES / 64;

    private static final int SEND_BUFFER_BYTES = 64 << 10; // so that it is the queue that shows how slow a client is

    /** Where a connection hands what happens; called on the connection's threads. */
    interface Owner {
        /** A whole frame has come; {@code done} is to be run once the boat has taken it. */
        void arrived(ClientConnection from, byte[] frame, Runnable done);

        /** The connection is closed, for a reason in words. Called once. */
        void closed(ClientConnection connection, String why);
    }

    private final Socket socket;
    private final Owner owner;
    private final String name;
    private final long number;
    private final FrameQueue queue;
    private final Semaphore unread = new Semaphore(MAX_UNREAD_BYTES);
    private final AtomicBoolean closed = new AtomicBoolean();
    private final Thread reader;
    private final Thread writer;
    private volatile boolean greeted;

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
        queue = new FrameQueue(config.maxQueuedFrames(), config.maxQueuedBytes());
        reader = thread(this::read, boatId + "-reads-" + name);
        writer = thread(this::write, boatId + "-writes-" + name);
    }

    private static Thread thread(Runnable work, String name) {
        Thread thread = new Thread(work, name);
        thread.setDaemon(true);
        return thread;
    }

    /** Begins to read and write. */
    void start() {
        reader.start();
        writer.start();
    }

    /** The client's address, for people. */
    String name() {
        return name;
    }

    /** Grows with each connection. */
    long number() {
        return number;
    }

    /** Whether the boat knows who it is. */
    boolean isGreeted() {
        return greeted;
    }

    void setGreeted(boolean value) {
        greeted = value;
    }

    @Override
    public void send(byte[] frame) {
        if (!queue.offer(frame)) {
            close("it does not take what it is sent");
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
            reader.interrupt(); // it may wait for the boat
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
            FrameReader frames = new FrameReader(new BufferedInputStream(socket.getInputStream()), new LinkCodec());
            for (Optional<byte[]> next = frames.next(); next.isPresent(); next = frames.next()) {
                int counted = Math.max(LEAST_UNREAD_BYTES, next.get().length);
                unread.acquire(counted);
                owner.arrived(this, next.get(), () -> unread.release(counted));
            }
            close("it has closed the link");
        } catch (LinkException e) {
            close("it sends what is no frame: " + e.getMessage());
        } catch (SocketTimeoutException e) {
            close("it has been silent for too long");
        } catch (IOException | InterruptedException e) {
            close("the link broke: " + e.getMessage());
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
