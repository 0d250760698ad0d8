package org.sami.boat.link;

import java.io.Closeable;
import java.io.IOException;
import java.util.concurrent.atomic.AtomicBoolean;

/**
 * The two threads of one connection: one reads a {@link FramePump}, one writes it. Closing the connection ends both. Knows no sockets: a
 * connection is what can be closed. Safe for use by several threads.
 */
public final class FrameThreads {
    private final FramePump pump;
    private final Closeable connection;
    private final AtomicBoolean closed = new AtomicBoolean();
    private final Thread reader;
    private final Thread writer;

    /**
     * Threads that do not run yet.
     *
     * @param connection closing it makes reads and writes on its streams fail
     * @param name the threads are named so, with {@code -reads} and {@code -writes} behind
     * @param read what the one does until the end of the stream
     * @param write what the other does until the pump is closed
     */
    public FrameThreads(FramePump pump, Closeable connection, String name, Runnable read, Runnable write) {
        this.pump = pump;
        this.connection = connection;
        reader = daemon(read, name + "-reads");
        writer = daemon(write, name + "-writes");
    }

    private static Thread daemon(Runnable work, String name) {
        Thread thread = new Thread(work, name);
        thread.setDaemon(true);
        return thread;
    }

    /** Starts the thread that reads. */
    public void startReading() {
        reader.start();
    }

    /** Starts the thread that writes. */
    public void startWriting() {
        writer.start();
    }

    /** Closes pump and connection, which ends both threads. Returns false if that was done before. */
    public boolean close() {
        if (!closed.compareAndSet(false, true)) {
            return false;
        }
        pump.close();
        try {
            connection.close();
        } catch (IOException e) {
            // it is closed for us all the same
        }
        reader.interrupt(); // it may wait for whoever takes the frames
        return true;
    }

    /** Waits until both threads have ended, after {@link #close}; not for these threads themselves. */
    public void join(long millis) throws InterruptedException {
        reader.join(millis);
        writer.join(millis);
    }
}
