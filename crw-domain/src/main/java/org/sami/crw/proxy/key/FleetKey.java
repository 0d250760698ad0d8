package org.sami.crw.proxy.key;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.time.Instant;
import java.util.HexFormat;

/**
 * The key with which the vehicles of other makers in a fleet sign, as people see it: its secret is shown to nobody.
 *
 * @param fingerprint sixteen digits by which people compare keys, the same as in {@code crw keys fleet}
 * @param since when it was put into the folder of this base's keys: made, or taken from a file
 */
public record FleetKey(String fingerprint, Instant since) {
    private static final int SHOWN_BYTES = 8;

    /** How a secret is shown. */
    static FleetKey of(byte[] secret, Instant since) {
        try {
            MessageDigest hash = MessageDigest.getInstance("SHA-256");
            hash.update("MAVLink signing key".getBytes(StandardCharsets.US_ASCII));
            return new FleetKey(HexFormat.of().formatHex(hash.digest(secret), 0, SHOWN_BYTES), since);
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("each Java has SHA-256", e);
        }
    }
}
