package org.sami.mavlink.link;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.Objects;

/** The secret of a fleet, with which its vehicles and bases sign their messages (MAVLink 2 signing). It is never shown; its fingerprint is. */
public final class SigningKey {
    /** How many bytes it has. */
    public static final int BYTES = 32;

    private static final int SHOWN_BYTES = 8;

    private final byte[] secret;

    /** A key.
     *
     * @throws IllegalArgumentException if it has not 32 bytes, or they are all zero, which turns signing off in vehicles
     */
    public SigningKey(byte[] secret) {
        Objects.requireNonNull(secret, "secret");
        this.secret = secret.clone();
        if (secret.length != BYTES || Arrays.equals(secret, new byte[BYTES])) {
            throw new IllegalArgumentException("a signing key has " + BYTES + " bytes, not all of them zero");
        }
    }

    /** The secret itself, for messages and for its file; a copy. */
    public byte[] secret() {
        return secret.clone();
    }

    /** Whether it is the same secret. */
    public boolean isSame(SigningKey other) {
        return MessageDigest.isEqual(secret, other.secret);
    }

    /** Sixteen digits by which people compare keys without seeing them. */
    public String fingerprint() {
        try {
            MessageDigest hash = MessageDigest.getInstance("SHA-256");
            hash.update("MAVLink signing key".getBytes(StandardCharsets.US_ASCII));
            return HexFormat.of().formatHex(hash.digest(secret), 0, SHOWN_BYTES);
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("each Java has SHA-256", e);
        }
    }

    /** Its fingerprint, so that no log shows the secret. */
    @Override
    public String toString() {
        return "signing key " + fingerprint();
    }
}
