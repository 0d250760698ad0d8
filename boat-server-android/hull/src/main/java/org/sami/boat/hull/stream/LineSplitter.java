package org.sami.boat.hull.stream;

import java.nio.charset.StandardCharsets;
import java.util.function.Consumer;

/**
 * Cuts bytes into ASCII lines of bounded length. A line that is too long is dropped up to its end, however long it is, and counted. CR and LF end lines; empty
 * lines are left out. Bytes outside ASCII become replacement characters. One thread.
 */
public final class LineSplitter {
    private final byte[] line;
    private final Consumer<String> lines;
    private int length;
    private boolean tooLong;
    private long dropped;

    /**
     * At the beginning of a line.
     *
     * @param maxBytes the longest line that is passed on, without its end
     * @param lines receives the lines, without their ends
     */
    public LineSplitter(int maxBytes, Consumer<String> lines) {
        if (maxBytes < 1) {
            throw new IllegalArgumentException("lines of " + maxBytes + " bytes");
        }
        line = new byte[maxBytes];
        this.lines = lines;
    }

    /** Takes the next bytes. */
    public void feed(byte[] bytes, int count) {
        for (int i = 0; i < count; i++) {
            byte next = bytes[i];
            if (next == '\n' || next == '\r') {
                end();
            } else if (length == line.length) {
                tooLong = true;
            } else {
                line[length++] = next;
            }
        }
    }

    private void end() {
        int ended = length;
        boolean whole = !tooLong;
        length = 0;
        tooLong = false;
        if (!whole) {
            dropped++;
        } else if (ended > 0) {
            lines.accept(new String(line, 0, ended, StandardCharsets.US_ASCII));
        }
    }

    /** How many lines were dropped because they were too long. */
    public long dropped() {
        return dropped;
    }
}
