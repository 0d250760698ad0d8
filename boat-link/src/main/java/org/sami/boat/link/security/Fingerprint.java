package org.sami.boat.link.security;

import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.security.PublicKey;
import java.util.Locale;
import java.util.Objects;

/** Names a key: the SHA-256 of a public key in its X.509 encoding, as 64 hexadecimal digits. Immutable. */
public final class Fingerprint implements Comparable<Fingerprint> {
    /** Number of hexadecimal digits. */
    public static final int DIGITS = 64;

    private static final int SHORT = 16;

    private final String hex;

    private Fingerprint(String hex) {
        this.hex = hex;
    }

    /** The fingerprint of a key. */
    public static Fingerprint of(PublicKey key) {
        byte[] digest = sha256(key.getEncoded());
        return new Fingerprint(Hex.of(digest));
    }

    /** Reads a fingerprint; what is none is an {@link IllegalArgumentException}. */
    public static Fingerprint parse(String text) {
        String digits = Objects.requireNonNull(text, "text").toLowerCase(Locale.ROOT);
        if (!digits.matches("[0-9a-f]{64}")) {
            throw new IllegalArgumentException("a fingerprint has 64 hexadecimal digits, not '" + text + "'");
        }
        return new Fingerprint(digits);
    }

    static byte[] sha256(byte[] bytes) {
        try {
            return MessageDigest.getInstance("SHA-256").digest(bytes);
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every Java and every Android has it", e);
        }
    }

    /** The first 16 digits, for people. */
    public String shortText() {
        return hex.substring(0, SHORT);
    }

    byte[] bytes() {
        return Hex.bytes(hex);
    }

    @Override
    public int compareTo(Fingerprint other) {
        return hex.compareTo(other.hex);
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Fingerprint && ((Fingerprint) other).hex.equals(hex);
    }

    @Override
    public int hashCode() {
        return hex.hashCode();
    }

    /** All digits. */
    @Override
    public String toString() {
        return hex;
    }
}
