package org.sami.spn.engine.codec;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/** Bytes that grow, without the locks of the streams of the library: states are written hundreds of thousands of times a second in searches. */
final class ByteSink {
    private byte[] bytes = new byte[512];
    private int length;

    void octet(int value) {
        makeRoom(1);
        bytes[length++] = (byte) value;
    }

    /** Four bytes, the highest first. */
    void integer(int value) {
        makeRoom(Integer.BYTES);
        for (int shift = 24; shift >= 0; shift -= 8) {
            bytes[length++] = (byte) (value >> shift);
        }
    }

    /** Eight bytes, the highest first. */
    void number(long value) {
        makeRoom(Long.BYTES);
        for (int shift = 56; shift >= 0; shift -= 8) {
            bytes[length++] = (byte) (value >> shift);
        }
    }

    /** The number of its bytes in UTF-8, then these. */
    void text(String text) {
        int chars = text.length();
        makeRoom(Integer.BYTES + chars);
        int start = length;
        integer(chars);
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
