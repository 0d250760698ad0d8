package org.sami.boat.link;

import java.io.Closeable;
import java.io.IOException;
import java.util.concurrent.atomic.AtomicBoolean;

/**
 * The two threads of one connection: one reads frames into a {@link FramePump}, one writes frames from it. Closing the connection ends both. A connection is
 * anything closeable, not necessarily a socket. Safe for use by several threads.
 */
public final class FrameThreads {
    private final FramePump pump;
    private final Closeable connection;
    private final AtomicBoolean closed = new AtomicBoolean();
    private final Thread reader;
    private final Thread writer;

    /**
     * Threads that are not started yet.
     *
     * @param connection closing it makes reads and writes on its streams fail
     * @param name prefix of the threads' names, before {@code -reads} and {@code -writes}
     * @param read the reading thread's work, until the end of the stream
     * @param write the writing thread's work, until the pump is closed
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
