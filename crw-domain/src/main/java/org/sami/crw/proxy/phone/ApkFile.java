package org.sami.crw.proxy.phone;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.URISyntaxException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.CodeSource;
import java.security.DigestInputStream;
import java.security.GeneralSecurityException;
import java.security.MessageDigest;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.LinkedHashSet;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.zip.ZipEntry;
import java.util.zip.ZipException;
import java.util.zip.ZipFile;

/**
 * The app for phones as a file. Nothing but an APK of the app is taken, so that no other file leaves this computer by mistake.
 *
 * @param bytes its length
 * @param sha256 of its content, in hexadecimal digits
 */
public record ApkFile(Path path, long bytes, String sha256) {
    /** Says how the file is made. */
    public static final String HOW_TO_MAKE =
            "make it by ./gradlew apk where SAMI is built (docs/boat-app.md), or name a copy of it";

    private static final String BUILT = "boat-server-android/app/build/sami-boat.apk";
    private static final String BESIDE = "sami-boat.apk";
    private static final String PACKAGE = "org.sami.boat.app";
    private static final long MOST_BYTES = 64_000_000;
    private static final int MOST_MANIFEST_BYTES = 1_000_000;
    private static final int LEVELS = 6;

    public ApkFile {
        Objects.requireNonNull(path, "path");
        Objects.requireNonNull(sha256, "sha256");
    }

    /**
     * Reads a file.
     *
     * @throws IOException in words, if it is missing, cannot be read, or is no APK of the app
     */
    public static ApkFile read(Path file) throws IOException {
        if (!Files.isRegularFile(file)) {
            throw new IOException("there is no file " + file + ": " + HOW_TO_MAKE);
        }
        long bytes = Files.size(file);
        if (bytes > MOST_BYTES) {
            throw new IOException(file + " is too large for the app: " + bytes + " bytes");
        }
        if (!isOfTheApp(file)) {
            throw new IOException(file + " is no APK of the app: " + HOW_TO_MAKE);
        }
        return new ApkFile(file, bytes, sha256(file));
    }

    private static boolean isOfTheApp(Path file) throws IOException {
        try (ZipFile zip = new ZipFile(file.toFile())) {
            ZipEntry manifest = zip.getEntry("AndroidManifest.xml");
            if (manifest == null || zip.getEntry("classes.dex") == null) {
                return false;
            }
            try (InputStream in = zip.getInputStream(manifest)) {
                byte[] text = in.readNBytes(MOST_MANIFEST_BYTES);
                return contains(text, PACKAGE.getBytes(StandardCharsets.UTF_16LE))
                        || contains(text, PACKAGE.getBytes(StandardCharsets.UTF_8));
            }
        } catch (ZipException noZip) {
            return false;
        }
    }

    private static boolean contains(byte[] text, byte[] part) {
        for (int i = 0; i + part.length <= text.length; i++) {
            if (Arrays.equals(text, i, i + part.length, part, 0, part.length)) {
                return true;
            }
        }
        return false;
    }

    private static String sha256(Path file) throws IOException {
        try {
            MessageDigest digest = MessageDigest.getInstance("SHA-256");
            try (InputStream in = new DigestInputStream(Files.newInputStream(file), digest)) {
                in.transferTo(OutputStream.nullOutputStream());
            }
            return HexFormat.of().formatHex(digest.digest());
        } catch (GeneralSecurityException e) {
            throw new IllegalStateException("every Java has SHA-256", e);
        }
    }

    /** Where {@code ./gradlew apk} has put it, seen from the working folder or from this program; empty where there is none. */
    public static Optional<Path> find() {
        return find(Path.of(""), ofThisProgram());
    }

    static Optional<Path> find(Path workingFolder, Optional<Path> program) {
        Set<Path> tried = new LinkedHashSet<>();
        program.map(Path::getParent).map(Path::getParent).ifPresent(installed -> tried.add(installed.resolve(BESIDE)));
        addAbove(workingFolder.toAbsolutePath().normalize(), tried);
        program.ifPresent(at -> addAbove(at, tried));
        return tried.stream().filter(Files::isRegularFile).findFirst();
    }

    private static void addAbove(Path from, Set<Path> tried) {
        Path at = from;
        for (int i = 0; i < LEVELS && at != null; i++) {
            tried.add(at.resolve(BUILT));
            at = at.getParent();
        }
    }

    private static Optional<Path> ofThisProgram() {
        CodeSource source = ApkFile.class.getProtectionDomain().getCodeSource();
        try {
            return source == null
                    ? Optional.empty()
                    : Optional.of(Path.of(source.getLocation().toURI()));
        } catch (URISyntaxException | IllegalArgumentException noFile) {
            return Optional.empty();
        }
    }

    /** Its length, for people: {@code 2.1 MB}. */
    public String size() {
        return String.format(Locale.ROOT, "%.1f MB", bytes / 1e6);
    }
}
