package org.sami.spn.journal;

import java.nio.ByteBuffer;
import java.util.HexFormat;

/** The 16 bytes that a journal keeps of a SHA-256. */
public record Checksum(long high, long low) {
    static final int BYTES = 2 * Long.BYTES;

    static Checksum of(byte[] digest) {
        ByteBuffer buffer = ByteBuffer.wrap(digest);
        return new Checksum(buffer.getLong(), buffer.getLong());
    }

    /** As they are stored. */
    public byte[] bytes() {
        return ByteBuffer.allocate(BYTES).putLong(high).putLong(low).array();
    }

    /** Whether these bytes, as read from a file, are this checksum. */
    boolean is(byte[] stored) {
        return stored.length == BYTES && equals(of(stored));
    }

    String hex() {
        return HexFormat.of().formatHex(bytes());
    }
}
