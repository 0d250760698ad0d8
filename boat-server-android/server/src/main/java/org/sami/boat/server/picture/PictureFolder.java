package org.sami.boat.server.picture;

import java.io.IOException;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Locale;
import java.util.Objects;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The folder in which one boat keeps its pictures, {@code BOAT-000012.jpg} and so on. It holds so many files and bytes at most: a new picture drives out
 * the oldest. Their age follows from their numbers, which go on over restarts, as a phone's clock may be set at any time. A picture has another name until
 * it is whole. Other files of the folder are left alone.
 *
 * <p>Safe for use by several threads. {@link #keep} writes to a disk, so not for the thread that drives the boat.
 */
public final class PictureFolder {
    /** Most pictures of a boat. */
    public static final int MOST_FILES = 500;

    /** Most bytes of all pictures of a boat. */
    public static final long MOST_BYTES = 100L << 20;

    /** Most bytes of one picture. */
    public static final int MOST_BYTES_OF_ONE = 8 << 20;

    private final Path folder;
    private final String boatId;
    private final Pattern names;
    private final int mostFiles;
    private final long mostBytes;
    private final SortedMap<Long, Long> bytesByNumber = new TreeMap<>(); // guarded by this
    private long lastNumber; // guarded by this

    private PictureFolder(Path folder, String boatId, int mostFiles, long mostBytes) {
        this.folder = Objects.requireNonNull(folder, "folder");
        this.boatId = Objects.requireNonNull(boatId, "boatId");
        this.mostFiles = mostFiles;
        this.mostBytes = mostBytes;
        names = Pattern.compile(Pattern.quote(boatId) + "-(\\d{6,18})\\.jpg");
    }

    /**
     * Opens or creates a boat's folder, with the usual bounds.
     *
     * @throws IOException if it cannot be had or read
     */
    public static PictureFolder open(Path folder, String boatId) throws IOException {
        return open(folder, boatId, MOST_FILES, MOST_BYTES);
    }

    /**
     * Opens or creates a boat's folder; what is over its bounds goes.
     *
     * @throws IOException if it cannot be had or read
     */
    public static PictureFolder open(Path folder, String boatId, int mostFiles, long mostBytes) throws IOException {
        if (mostFiles < 1 || mostBytes < 1) {
            throw new IllegalArgumentException("a folder for " + mostFiles + " pictures of " + mostBytes + " bytes");
        }
        PictureFolder opened = new PictureFolder(folder, boatId, mostFiles, mostBytes);
        opened.read();
        return opened;
    }

    private synchronized void read() throws IOException {
        Files.createDirectories(folder);
        try (DirectoryStream<Path> files = Files.newDirectoryStream(folder)) {
            for (Path file : files) {
                Matcher name = names.matcher(
                        Objects.requireNonNull(file.getFileName(), "name").toString());
                if (name.matches()) {
                    long number = Long.parseLong(name.group(1));
                    bytesByNumber.put(number, Files.size(file));
                    lastNumber = Math.max(lastNumber, number);
                }
            }
        }
        makeRoom();
    }

    /** The folder. */
    public Path folder() {
        return folder;
    }

    /** A name for the next picture, which no other picture of this boat has had. */
    public synchronized String nextName() {
        lastNumber++;
        return name(lastNumber);
    }

    private String name(long number) {
        return boatId + String.format(Locale.ROOT, "-%06d.jpg", number);
    }

    /**
     * Keeps a picture; the oldest ones go for it where the folder is full.
     *
     * @param name from {@link #nextName}
     * @throws IOException if it is too large or cannot be written; nothing of it is left then
     */
    public synchronized void keep(String name, byte[] picture) throws IOException {
        Matcher matcher = names.matcher(name);
        if (!matcher.matches()) {
            throw new IllegalArgumentException(name + " is no name of a picture of " + boatId);
        }
        if (picture.length > Math.min(MOST_BYTES_OF_ONE, mostBytes)) {
            throw new IOException(name + " has " + picture.length + " bytes, more than "
                    + Math.min(MOST_BYTES_OF_ONE, mostBytes) + ": it is not kept");
        }
        Path part = folder.resolve(name + ".part");
        try {
            Files.write(part, picture);
            move(part, folder.resolve(name));
        } catch (IOException e) {
            Files.deleteIfExists(part);
            throw e;
        }
        bytesByNumber.put(Long.parseLong(matcher.group(1)), (long) picture.length);
        makeRoom();
    }

    private static void move(Path from, Path to) throws IOException {
        try {
            Files.move(from, to, StandardCopyOption.ATOMIC_MOVE);
        } catch (AtomicMoveNotSupportedException e) {
            Files.move(from, to, StandardCopyOption.REPLACE_EXISTING);
        }
    }

    private void makeRoom() throws IOException {
        long bytes = bytesByNumber.values().stream().mapToLong(Long::longValue).sum();
        while (bytesByNumber.size() > mostFiles || bytes > mostBytes) {
            long oldest = bytesByNumber.firstKey();
            Files.deleteIfExists(folder.resolve(name(oldest)));
            bytes -= bytesByNumber.remove(oldest);
        }
    }
}
