package org.sami.boat.hull.stream;

import java.io.Closeable;
import java.io.IOException;
import java.util.Optional;
import java.util.concurrent.locks.LockSupport;

/**
 * Keeps a port open: reads its lines on a thread of its own, and opens it again, once a second, when it is gone. Safe for use by several threads.
 */
public final class ReconnectingPort implements Closeable {
    private static final long RETRY_NANOS = 1_000_000_000L;
    private static final int BUFFER = 4096;

    private final StreamPort port;
    private final int maxLine;
    private final PortListener listener;
    private final Thread reader;
    private final Object lock = new Object();
    private Optional<StreamConnection> connection = Optional.empty(); // guarded by the lock
    private volatile boolean closed;
    private volatile String endedBy = "";

    /**
     * A port that is not open yet.
     *
     * @param maxLine the longest line that is passed on, in bytes
     */
    public ReconnectingPort(StreamPort port, int maxLine, PortListener listener) {
        this.port = port;
        this.maxLine = maxLine;
        this.listener = listener;
        reader = new Thread(this::run, port.name());
        reader.setDaemon(true);
    }

    /** Opens the port at once, before {@link #start}, to see whether it is there. */
    public void openFirst() throws IOException {
        enter(port.open());
    }

    private void enter(StreamConnection opened) {
        synchronized (lock) {
            connection = Optional.of(opened);
        }
    }

    private Optional<StreamConnection> current() {
        synchronized (lock) {
            return connection;
        }
    }

    /** Begins to read; once only. */
    public void start() {
        reader.start();
    }

    private void run() {
        String lastWhy = "";
        while (!closed) {
            try {
                if (!current().isPresent()) {
                    enter(port.open());
                }
                endedBy = "";
                lastWhy = "";
                listener.opened();
                read(current());
            } catch (IOException | RuntimeException e) {
                String why = endedBy.isEmpty() ? words(e) : endedBy;
                if (!closed && !why.equals(lastWhy)) {
                    lastWhy = why;
                    listener.lost(why);
                }
            }
            drop();
            if (!closed) {
                LockSupport.parkNanos(RETRY_NANOS);
            }
        }
    }

    private void read(Optional<StreamConnection> open) throws IOException {
        byte[] buffer = new byte[BUFFER];
        LineSplitter splitter = new LineSplitter(maxLine, listener::line);
        while (!closed && open.isPresent()) {
            int count = open.get().in().read(buffer);
            if (count < 0) {
                throw new IOException("the other side has closed it");
            }
            splitter.feed(buffer, count);
        }
    }

    private static String words(Exception e) {
        String said = e.getMessage();
        return said == null || said.isEmpty() ? e.getClass().getSimpleName() : said;
    }

    /** Sends bytes to the device; waits where the device takes none. */
    public void send(byte[] bytes) throws IOException {
        Optional<StreamConnection> open = current();
        if (!open.isPresent()) {
            throw new IOException(port.name() + " is not open");
        }
        open.get().out().write(bytes);
        open.get().out().flush();
    }

    /** Closes the connection, so that the port is opened again. */
    public void reopen(String why) {
        endedBy = why;
        drop();
    }

    private void drop() {
        Optional<StreamConnection> open;
        synchronized (lock) {
            open = connection;
            connection = Optional.empty();
        }
        if (open.isPresent()) {
            try {
                open.get().close();
            } catch (IOException alreadyGone) {
                // nothing is left to be closed
            }
        }
    }

    /** Closes the port and ends its thread. */
    @Override
    public void close() {
        closed = true;
        drop();
        LockSupport.unpark(reader);
    }
}
