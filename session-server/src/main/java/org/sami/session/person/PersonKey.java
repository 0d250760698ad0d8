package org.sami.session.person;

import java.nio.charset.StandardCharsets;
import java.security.GeneralSecurityException;
import java.security.MessageDigest;
import java.security.SecureRandom;
import java.util.HexFormat;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.crypto.SecretKeyFactory;
import javax.crypto.spec.PBEKeySpec;
import org.sami.boat.link.security.PairingSecret;

/**
 * Keys of people: six words, as boats show them for pairing, so that a person can type them on a phone. They have 60 random bits, which a file of plain hashes would
 * not protect: what is kept is PBKDF2 with a salt. Keys of 32 characters, as they were until November 2026, still count.
 */
public final class PersonKey {
    private static final int ROUNDS = 100_000; // of PBKDF2: some 0.1 s of a laptop a login
    private static final int SALT_BYTES = 16;
    private static final int HASH_BITS = 256;
    private static final Pattern KEPT = Pattern.compile("pbkdf2:([0-9]{1,8}):([0-9a-f]{32}):([0-9a-f]{64})");

    private PersonKey() {}

    /** A key that nobody had before, words with a space between them. */
    public static String generate() {
        return PairingSecret.random().toString();
    }

    /** What is kept of a key; another text each time, as the salt is. */
    public static String hash(String key) {
        byte[] salt = new byte[SALT_BYTES];
        new SecureRandom().nextBytes(salt);
        return "pbkdf2:" + ROUNDS + ":" + HexFormat.of().formatHex(salt) + ":" + derived(key, salt, ROUNDS);
    }

    /** Whether a key, as a person typed it, has that hash; takes as long for a wrong key as for the right one. */
    static boolean matches(String key, String hash) {
        Matcher kept = KEPT.matcher(hash);
        if (!kept.matches()) {
            return MessageDigest.isEqual(
                    sha256(key).getBytes(StandardCharsets.US_ASCII), hash.getBytes(StandardCharsets.US_ASCII));
        }
        String derived = derived(key, HexFormat.of().parseHex(kept.group(2)), Integer.parseInt(kept.group(1)));
        return MessageDigest.isEqual(
                derived.getBytes(StandardCharsets.US_ASCII), kept.group(3).getBytes(StandardCharsets.US_ASCII));
    }

    /** Six words count however they are typed: in any case, with whatever between them, each by its first four letters. */
    private static String meant(String typed) {
        try {
            return PairingSecret.parse(typed).toString();
        } catch (IllegalArgumentException otherKey) {
            return typed;
        }
    }

    private static String derived(String key, byte[] salt, int rounds) {
        PBEKeySpec spec = new PBEKeySpec(meant(key).toCharArray(), salt, rounds, HASH_BITS);
        try {
            byte[] derived = SecretKeyFactory.getInstance("PBKDF2WithHmacSHA256")
                    .generateSecret(spec)
                    .getEncoded();
            return HexFormat.of().formatHex(derived);
        } catch (GeneralSecurityException e) {
            throw new IllegalStateException("every Java has it", e);
        } finally {
            spec.clearPassword();
        }
    }

    private static String sha256(String key) {
        try {
            return HexFormat.of()
                    .formatHex(MessageDigest.getInstance("SHA-256").digest(key.getBytes(StandardCharsets.UTF_8)));
        } catch (GeneralSecurityException e) {
            throw new IllegalStateException("every Java has SHA-256", e);
        }
    }
}
