package org.sami.boat.link.security;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.SecureRandom;
import java.util.Arrays;
import java.util.Base64;
import java.util.Optional;
import javax.crypto.AEADBadTagException;
import javax.crypto.Cipher;
import javax.crypto.SecretKeyFactory;
import javax.crypto.spec.GCMParameterSpec;
import javax.crypto.spec.PBEKeySpec;
import javax.crypto.spec.SecretKeySpec;

/**
 * The keys of a base in one encrypted file, to take them to a second laptop: AES-256-GCM under a key made of a password by PBKDF2 with HMAC-SHA-256.
 */
public final class KeyBundle {
    private static final byte[] BEGIN = "SAMI keys 1\n".getBytes(StandardCharsets.US_ASCII);
    private static final int ROUNDS = 600_000;
    private static final int SALT_BYTES = 16;
    private static final int IV_BYTES = 12;
    private static final int TAG_BITS = 128;
    private static final int KEY_BITS = 256;
    private static final String BETWEEN = "peers\n";
    private static final String FLEET = "fleet ";

    private KeyBundle() {}

    /** Writes the own key, the peers and the withdrawn keys, and the secret of a fleet where there is one. */
    public static void write(Path file, KeyRing keys, Optional<byte[]> fleetKey, char[] password) throws IOException {
        SecureRandom random = new SecureRandom();
        byte[] salt = new byte[SALT_BYTES];
        byte[] iv = new byte[IV_BYTES];
        random.nextBytes(salt);
        random.nextBytes(iv);
        String fleet = fleetKey.map(secretOfFleet -> FLEET + Base64.getEncoder().encodeToString(secretOfFleet) + "\n")
                .orElse("");
        String text = fleet
                + KeyStoreFolder.text(keys.identity())
                + BETWEEN
                + keys.content().text();
        byte[] secret = crypt(Cipher.ENCRYPT_MODE, salt, iv, password, text.getBytes(StandardCharsets.UTF_8), file);
        ByteBuffer whole = ByteBuffer.allocate(BEGIN.length + SALT_BYTES + IV_BYTES + secret.length);
        OwnerOnlyFile.write(file, whole.put(BEGIN).put(salt).put(iv).put(secret).array());
    }

    /**
     * Reads such a file into a folder, in place of the keys there.
     *
     * @throws IOException if the file is none, or damaged, or if the password is another one
     */
    public static KeyRing read(Path file, char[] password, KeyStoreFolder into) throws IOException {
        byte[] whole = OwnerOnlyFile.bytes(file);
        int head = BEGIN.length + SALT_BYTES + IV_BYTES;
        if (whole.length < head || !Arrays.equals(Arrays.copyOf(whole, BEGIN.length), BEGIN)) {
            throw new IOException(file + " is no file of keys");
        }
        byte[] salt = Arrays.copyOfRange(whole, BEGIN.length, BEGIN.length + SALT_BYTES);
        byte[] iv = Arrays.copyOfRange(whole, BEGIN.length + SALT_BYTES, head);
        byte[] secret = Arrays.copyOfRange(whole, head, whole.length);
        String text = new String(crypt(Cipher.DECRYPT_MODE, salt, iv, password, secret, file), StandardCharsets.UTF_8);
        int between = text.indexOf(BETWEEN);
        if (between < 0) {
            throw new IOException(file + " is damaged");
        }
        int begin = 0;
        Optional<byte[]> fleetKey = Optional.empty();
        if (text.startsWith(FLEET)) {
            begin = text.indexOf('\n') + 1;
            fleetKey = Optional.of(
                    fleetKey(file, text.substring(FLEET.length(), begin).trim()));
        }
        Identity identity = KeyStoreFolder.parse(file.toString(), text.substring(begin, between));
        KeyRing.Content content = KeyRing.Content.parse(file.toString(), text.substring(between + BETWEEN.length()));
        into.write(identity, content);
        if (fleetKey.isPresent()) {
            into.writeFleetKey(fleetKey.get());
        }
        return into.open();
    }

    private static byte[] fleetKey(Path file, String text) throws IOException {
        try {
            return Base64.getDecoder().decode(text);
        } catch (IllegalArgumentException e) {
            throw new IOException(file + " is damaged", e);
        }
    }

    private static byte[] crypt(int mode, byte[] salt, byte[] iv, char[] password, byte[] bytes, Path file)
            throws IOException {
        try {
            PBEKeySpec spec = new PBEKeySpec(password, salt, ROUNDS, KEY_BITS);
            byte[] key = SecretKeyFactory.getInstance("PBKDF2WithHmacSHA256")
                    .generateSecret(spec)
                    .getEncoded();
            spec.clearPassword();
            Cipher cipher = Cipher.getInstance("AES/GCM/NoPadding");
            cipher.init(mode, new SecretKeySpec(key, "AES"), new GCMParameterSpec(TAG_BITS, iv));
            cipher.updateAAD(BEGIN);
            return cipher.doFinal(bytes);
        } catch (AEADBadTagException e) {
            throw new IOException(file + ": the password is another one, or the file is damaged", e);
        } catch (GeneralSecurityException e) {
            throw new IllegalStateException("every Java and every Android has it", e);
        }
    }
}
