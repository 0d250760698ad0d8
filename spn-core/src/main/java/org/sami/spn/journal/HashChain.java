package org.sami.spn.journal;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;

/**
 * The checksums of a journal: 16 bytes of SHA-256. That of an entry covers that of its predecessor, so that an entry that
 * is missing, twice, out of order or changed shows; that of the first covers the header's. Used by one thread.
 */
final class HashChain {
    private final MessageDigest digest = sha256();
    private final ByteBuffer numbers = ByteBuffer.allocate(2 * Long.BYTES);

    Checksum header(Iterable<String> parts) {
        for (String part : parts) {
            byte[] bytes = part.getBytes(StandardCharsets.UTF_8);
            numbers(bytes.length, 0);
            digest.update(bytes);
        }
        return end();
    }

    Checksum entry(Checksum previous, long index, long atMillis, byte[] input) {
        numbers(previous.high(), previous.low());
        numbers(index, atMillis);
        digest.update(input);
        return end();
    }

    /** Of a snapshot or a mark, bound to the entry that it follows. */
    Checksum attached(Checksum entry, String kind, byte[] content) {
        numbers(entry.high(), entry.low());
        digest.update(kind.getBytes(StandardCharsets.UTF_8));
        digest.update(content);
        return end();
    }

    private void numbers(long first, long second) {
        numbers.clear();
        numbers.putLong(first).putLong(second);
        digest.update(numbers.array());
    }

    private Checksum end() {
        return Checksum.of(digest.digest());
    }

    private static MessageDigest sha256() {
        try {
            return MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException missing) {
            throw new IllegalStateException("every Java platform has SHA-256", missing);
        }
    }
}
