package org.sami.crw.proxy.file;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import org.sami.boat.link.KeptFile;

/**
 * The copy of one file in a folder of this machine. What has come stands in {@code NAME.part}; the file itself is whole, with the hash that the boat listed. A copy with other content
 * is kept next to it as {@code NAME.1}, {@code NAME.2} and so on.
 */
final class FileCopy {
    private static final int BUFFER_BYTES = 64 << 10;
    private static final int MOST_AT_ONCE = 1 << 20; // a link gives less at once

    /** Receives how it goes. */
    interface Arrival {
        /** A piece is written: so many bytes are here now, and the piece had so many. */
        void come(long here, int piece);
    }

    private final KeptFile wanted;
    private final Path whole;
    private final Path part;

    FileCopy(KeptFile wanted, Path folder) {
        this.wanted = wanted;
        whole = folder.resolve(wanted.name());
        part = folder.resolve(wanted.name() + ".part");
    }

    /** The whole file. */
    Path path() {
        return whole;
    }

    /** Whether it is here already. */
    boolean isHere() throws IOException {
        return Files.isRegularFile(whole)
                && Files.size(whole) == wanted.bytes()
                && hash(whole, wanted.bytes()).equals(wanted.sha256());
    }

    /**
     * Fetches what is missing.
     *
     * @param arrival called after each piece
     * @throws IOException if the link breaks; what has come is kept
     * @throws FileFetchException if the boat does not give it, or something else than it listed
     */
    void fetch(BoatFileSource link, Arrival arrival) throws IOException {
        if (isHere()) {
            return;
        }
        if (wanted.isTooLarge()) {
            throw new FileFetchException(link.boatId() + ": " + wanted.name() + " has " + wanted.bytes()
                    + " bytes, more than the " + KeptFile.MAX_BYTES + " that a boat gives");
        }
        Files.createDirectories(whole.toAbsolutePath().getParent());
        boolean fromCopy = !Files.exists(part) && Files.isRegularFile(whole) && Files.size(whole) < wanted.bytes();
        if (fromCopy) {
            Files.copy(whole, part);
        }
        if (Files.exists(part) && Files.size(part) > wanted.bytes()) {
            Files.delete(part);
        }
        boolean resumed = Files.exists(part) && Files.size(part) > 0;
        append(link, arrival);
        if (resumed && !isPartRight()) { // its beginning is of another file
            Files.delete(part);
            append(link, arrival);
        }
        if (!isPartRight()) {
            Files.delete(part);
            throw new FileFetchException(link.boatId() + ": " + wanted.name()
                    + " has changed while it was fetched; what came is not kept, fetch it again");
        }
        keepOther();
        Files.move(part, whole, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
    }

    private void append(BoatFileSource link, Arrival arrival) throws IOException {
        long here = Files.exists(part) ? Files.size(part) : 0;
        try (OutputStream out = Files.newOutputStream(part, StandardOpenOption.CREATE, StandardOpenOption.APPEND)) {
            while (here < wanted.bytes()) {
                int most = (int) Math.min(MOST_AT_ONCE, wanted.bytes() - here);
                byte[] piece = link.piece(wanted.name(), here, most);
                if (piece.length == 0 || piece.length > most) {
                    throw new FileFetchException(link.boatId() + ": " + wanted.name() + " ends at byte " + here + " of "
                            + wanted.bytes() + "; fetch it again");
                }
                write(out, piece);
                here += piece.length;
                arrival.come(here, piece.length);
            }
        }
    }

    /** A fault of the disk here is another kind of exception than one of the link. */
    private void write(OutputStream out, byte[] piece) throws FileSystemException {
        try {
            out.write(piece);
        } catch (IOException e) {
            throw new FileSystemException(part.toString(), null, String.valueOf(e.getMessage()));
        }
    }

    private boolean isPartRight() throws IOException {
        return Files.size(part) == wanted.bytes() && hash(part, wanted.bytes()).equals(wanted.sha256());
    }

    /** A copy that is no beginning of what has come is of a file that the boat keeps no longer. */
    private void keepOther() throws IOException {
        if (!Files.exists(whole)) {
            return;
        }
        long bytes = Files.size(whole);
        boolean grown = bytes <= wanted.bytes() && hash(whole, bytes).equals(hash(part, bytes));
        if (!grown) {
            int number = 1;
            while (Files.exists(whole.resolveSibling(wanted.name() + "." + number))) {
                number++;
            }
            Files.move(whole, whole.resolveSibling(wanted.name() + "." + number));
        }
    }

    private static String hash(Path file, long bytes) throws IOException {
        try (InputStream in = Files.newInputStream(file)) {
            MessageDigest digest = MessageDigest.getInstance("SHA-256");
            byte[] buffer = new byte[BUFFER_BYTES];
            long left = bytes;
            while (left > 0) {
                int read = in.read(buffer, 0, (int) Math.min(buffer.length, left));
                if (read < 0) {
                    return "";
                }
                digest.update(buffer, 0, read);
                left -= read;
            }
            return HexFormat.of().formatHex(digest.digest());
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every Java has SHA-256", e);
        }
    }
}
