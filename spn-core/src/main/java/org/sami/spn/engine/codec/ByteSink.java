package org.sami.spn.engine.codec;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/** Bytes that grow, without the locks of the streams of the library: states are written hundreds of thousands of times a second in searches. */
final class ByteSink {
    /** Of a compact number. */
    private static final int MOST_BYTES = 10;

    private final boolean compact;
    private byte[] bytes = new byte[1024];
    private int length;

    /**
     * No bytes yet.
     *
     * @param compact whether small numbers take fewer bytes: seven bits a byte, the lowest first, negative ones between the others
     */
    ByteSink(boolean compact) {
        this.compact = compact;
    }

    void octet(int value) {
        makeRoom(1);
        bytes[length++] = (byte) value;
    }

    /** Four bytes, the highest first; or, compact, up to five. */
    void integer(int value) {
        if (compact) {
            compact(value);
            return;
        }
        makeRoom(Integer.BYTES);
        for (int shift = 24; shift >= 0; shift -= 8) {
            bytes[length++] = (byte) (value >> shift);
        }
    }

    /** Eight bytes, the highest first; or, compact, up to ten. */
    void number(long value) {
        if (compact) {
            compact(value);
            return;
        }
        makeRoom(Long.BYTES);
        for (int shift = 56; shift >= 0; shift -= 8) {
            bytes[length++] = (byte) (value >> shift);
        }
    }

    private void compact(long value) {
        makeRoom(MOST_BYTES);
        long left = value << 1 ^ value >> 63;
        while (left >>> 7 != 0) {
            bytes[length++] = (byte) (left | 0x80);
            left >>>= 7;
        }
        bytes[length++] = (byte) left;
    }

    /** The number of its bytes in UTF-8, then these. */
    void text(String text) {
        int chars = text.length();
        int start = length;
        integer(chars);
        makeRoom(chars);
        for (int i = 0; i < chars; i++) {
            char c = text.charAt(i);
            if (c >= 0x80) {
                length = start;
                encoded(text.getBytes(StandardCharsets.UTF_8));
                return;
            }
            bytes[length++] = (byte) c;
        }
    }

    private void encoded(byte[] utf8) {
        integer(utf8.length);
        makeRoom(utf8.length);
        System.arraycopy(utf8, 0, bytes, length, utf8.length);
        length += utf8.length;
    }

    byte[] toBytes() {
        return Arrays.copyOf(bytes, length);
    }

    private void makeRoom(int more) {
        if (bytes.length - length < more) {
            bytes = Arrays.copyOf(bytes, Math.max(bytes.length * 2, Math.addExact(length, more)));
        }
    }
}
