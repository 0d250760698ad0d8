package org.sami.boat.link.security;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyFactory;
import java.security.cert.CertificateFactory;
import java.security.cert.X509Certificate;
import java.security.spec.PKCS8EncodedKeySpec;
import java.time.Instant;
import java.util.Base64;
import java.util.Optional;
import org.sami.boat.link.security.KeyRing.Content;

/**
 * The keys of a boat or base in a folder: its own in {@code identity}, those of its peers in {@code peers}, and at a base the secret with which its fleet of
 * other makers' vehicles signs in {@code fleet}. Only their user can read these files. A phone may
 * keep its own key elsewhere and only the peers here.
 */
public final class KeyStoreFolder {
    private final Path folder;

    /** The keys in a folder, which need not exist yet. */
    public KeyStoreFolder(Path folder) {
        this.folder = folder;
    }

    /** Whether there is a key already. */
    public boolean exists() {
        return Files.exists(identityFile());
    }

    private Path identityFile() {
        return folder.resolve("identity");
    }

    private Path peersFile() {
        return folder.resolve("peers");
    }

    /**
     * The keys; an own key is made if there is none yet.
     *
     * @throws IOException if a file is damaged, cannot be read or written, or may be read by others
     */
    public KeyRing open() throws IOException {
        if (!exists()) {
            write(Identity.generate());
        }
        return open(identity());
    }

    /** The peers in the folder next to a key that is kept elsewhere. */
    public KeyRing open(Identity identity) throws IOException {
        Content content =
                Files.exists(peersFile()) ? Content.parse(peersFile().toString(), text(peersFile())) : Content.EMPTY;
        return new KeyRing(
                identity,
                content,
                next -> OwnerOnlyFile.write(peersFile(), next.text().getBytes(StandardCharsets.UTF_8)));
    }

    private Identity identity() throws IOException {
        return parse(identityFile().toString(), text(identityFile()));
    }

    private static String text(Path file) throws IOException {
        return new String(OwnerOnlyFile.read(file), StandardCharsets.UTF_8);
    }

    /**
     * The secret with which a fleet of other makers' vehicles signs its messages; empty where there is none.
     *
     * @throws IOException if it is damaged, cannot be read, or may be read by others
     */
    public Optional<byte[]> fleetKey() throws IOException {
        if (!Files.exists(fleetFile())) {
            return Optional.empty();
        }
        try {
            return Optional.of(Base64.getDecoder().decode(text(fleetFile()).trim()));
        } catch (IllegalArgumentException e) {
            throw new IOException(fleetFile() + " holds no key that can be read", e);
        }
    }

    /**
     * When the secret of a fleet was put there; empty where there is none.
     *
     * @throws IOException if that cannot be read
     */
    public Optional<Instant> fleetKeySince() throws IOException {
        return Files.exists(fleetFile())
                ? Optional.of(Files.getLastModifiedTime(fleetFile()).toInstant())
                : Optional.empty();
    }

    /** Keeps a secret of a fleet in place of the present one. */
    public void writeFleetKey(byte[] secret) throws IOException {
        OwnerOnlyFile.write(
                fleetFile(), (Base64.getEncoder().encodeToString(secret) + "\n").getBytes(StandardCharsets.UTF_8));
    }

    private Path fleetFile() {
        return folder.resolve("fleet");
    }

    /** Keeps an own key in place of the present one. */
    public void write(Identity identity) throws IOException {
        OwnerOnlyFile.write(identityFile(), text(identity).getBytes(StandardCharsets.UTF_8));
    }

    /** Replaces all keys. */
    void write(Identity identity, Content content) throws IOException {
        OwnerOnlyFile.write(peersFile(), content.text().getBytes(StandardCharsets.UTF_8));
        write(identity);
    }

    /** An identity as two lines: key and certificate in Base64. */
    static String text(Identity identity) throws IOException {
        try {
            Base64.Encoder base64 = Base64.getEncoder();
            return base64.encodeToString(identity.key().getEncoded()) + "\n"
                    + base64.encodeToString(identity.certificate().getEncoded()) + "\n";
        } catch (GeneralSecurityException e) {
            throw new IOException("the certificate cannot be written", e);
        }
    }

    static Identity parse(String where, String text) throws IOException {
        String[] lines = text.trim().split("\n");
        try {
            if (lines.length != 2) {
                throw new IllegalArgumentException("not two lines");
            }
            byte[] key = Base64.getDecoder().decode(lines[0].trim());
            byte[] certificate = Base64.getDecoder().decode(lines[1].trim());
            return new Identity(
                    KeyFactory.getInstance("EC").generatePrivate(new PKCS8EncodedKeySpec(key)),
                    (X509Certificate) CertificateFactory.getInstance("X.509")
                            .generateCertificate(new ByteArrayInputStream(certificate)));
        } catch (GeneralSecurityException | IllegalArgumentException e) {
            throw new IOException(where + " holds no key that can be read: " + e.getMessage(), e);
        }
    }
}
