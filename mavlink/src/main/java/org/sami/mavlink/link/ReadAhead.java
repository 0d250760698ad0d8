package org.sami.mavlink.link;

import java.io.IOException;
import java.io.InputStream;
import java.util.concurrent.atomic.AtomicLong;

/** Reads as much at once as there is, as the library takes one byte after the other, and counts it. Read by one thread; its count is for any. */
final class ReadAhead extends InputStream {
    private static final int ROOM = 4_096;
    private static final int BYTE = 0xff;
    private static final int BEGIN_1 = 0xfe; // the first byte of a packet of MAVLink 1
    private static final int BEGIN_2 = 0xfd;
    private static final int AROUND_1 = 8; // bytes of a packet besides its payload
    private static final int AROUND_2 = 12;
    private static final int SIGNATURE = 13;
    private static final int SIGNED = 1; // of the flags
    private static final int HEAD = 3; // bytes that tell how long a packet is

    private final InputStream in;
    private final byte[] room = new byte[ROOM];
    private int next;
    private int end;
    private final AtomicLong bytes = new AtomicLong();

    ReadAhead(InputStream in) {
        this.in = in;
    }

    /** How many bytes came. */
    long bytes() {
        return bytes.get();
    }

    /** Whether the bytes that came already begin with a whole packet, so that it can be read without waiting for more. */
    boolean holdsPacket() {
        if (end - next < HEAD) {
            return false;
        }
        int length = room[next + 1] & BYTE;
        return switch (room[next] & BYTE) {
            case BEGIN_1 -> end - next >= length + AROUND_1;
            case BEGIN_2 -> end - next >= length + AROUND_2 + ((room[next + 2] & SIGNED) == 0 ? 0 : SIGNATURE);
            default -> false;
        };
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
            int came = in.read(room, 0, ROOM);
            if (came < 0) {
                return true;
            }
            next = 0;
            end = came;
            bytes.addAndGet(came);
        }
        return next == end;
    }

    @Override
    public void close() throws IOException {
        in.close();
    }
}
