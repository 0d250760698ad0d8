package org.sami.mavlink.link;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.atomic.AtomicLong;

/** Reads as much at once as there is, as the library takes one byte after the other, and counts it. Read by one thread; its count is for any. */
final class ReadAhead extends InputStream {
    private static final int ROOM = 4_096;
    private static final int BYTE = 0xff;
    private static final int FIRST = 8;

    private final InputStream in;
    private final Runnable beforeWaiting;
    private final byte[] room = new byte[ROOM];
    private volatile String first = ""; // written by the reading thread alone
    private int next;
    private int end;
    private final AtomicLong bytes = new AtomicLong();

    /**
     * Bytes of a stream.
     *
     * @param beforeWaiting called each time that all bytes which came are read, before more are waited for
     */
    ReadAhead(InputStream in, Runnable beforeWaiting) {
        this.in = in;
        this.beforeWaiting = beforeWaiting;
    }

    /** The first bytes that came as characters; empty where none came. For any thread. */
    String first() {
        return first;
    }

    /** How many bytes came. */
    long bytes() {
        return bytes.get();
    }

    @Override
    public int read() throws IOException {
        return isOver() ? -1 : room[next++] & BYTE;
    }

    @Override
    public int read(byte[] to, int from, int length) throws IOException {
        if (length == 0) {
            return 0;
        }
        if (isOver()) {
            return -1;
        }
        int part = Math.min(length, end - next);
        System.arraycopy(room, next, to, from, part);
        next += part;
        return part;
    }

    /** Waits for more where nothing is left; whether there is none. */
    private boolean isOver() throws IOException {
        if (next == end) {
            beforeWaiting.run();
            int came = in.read(room, 0, ROOM);
            if (came < 0) {
                return true;
            }
            next = 0;
            end = came;
            if (first.isEmpty()) {
                first = new String(room, 0, Math.min(came, FIRST), StandardCharsets.ISO_8859_1);
            }
            bytes.addAndGet(came);
        }
        return next == end;
    }

    @Override
    public void close() throws IOException {
        in.close();
    }
}
