package org.sami.boat.server.log;

import java.io.IOException;
import java.io.UnsupportedEncodingException;
import java.net.URLDecoder;
import java.net.URLEncoder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.zip.CRC32;
import org.sami.boat.link.CommandEpoch;

/**
 * Keeps a boat's newest {@link CommandEpoch} in a file of one line. Each one replaces the file as a whole, so that the death of the process leaves the old
 * or the new one. The line's parts, divided by tabs, are a checksum of the rest, the number, the session and the client, both in URL encoding.
 */
final class EpochFile {
    private static final int MOST_BYTES = 4096;

    private final Path file;

    /** The file next to a boat's log. */
    EpochFile(Path log) {
        file = log.resolveSibling(log.getFileName() + ".epoch");
    }

    /**
     * Reads what is kept; {@link CommandEpoch#NONE} without a file.
     *
     * @throws IOException if the file is damaged: the boat would obey bases that were replaced
     */
    CommandEpoch read() throws IOException {
        byte[] bytes;
        try {
            if (Files.size(file) > MOST_BYTES) {
                throw damaged();
            }
            bytes = Files.readAllBytes(file);
        } catch (NoSuchFileException e) {
            return CommandEpoch.NONE;
        }
        String[] parts = new String(bytes, StandardCharsets.UTF_8).trim().split("\t", -1);
        try {
            if (parts.length != 4 || !parts[0].equals(checksum(parts[1] + "\t" + parts[2] + "\t" + parts[3]))) {
                throw damaged();
            }
            return new CommandEpoch(Long.parseLong(parts[1]), decoded(parts[2]), decoded(parts[3]));
        } catch (IllegalArgumentException e) {
            throw damaged();
        }
    }

    private IOException damaged() {
        return new IOException(
                file
                        + " is damaged: it says who commanded the boat last. Remove it if no other base is in use, and take the command anew");
    }

    /** Replaces what is kept. */
    void write(CommandEpoch epoch) throws IOException {
        String rest = epoch.number() + "\t" + encoded(epoch.session()) + "\t" + encoded(epoch.clientId());
        Path next = file.resolveSibling(file.getFileName() + ".next");
        Files.write(next, (checksum(rest) + "\t" + rest + "\n").getBytes(StandardCharsets.UTF_8));
        Files.move(next, file, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
    }

    private static String checksum(String text) {
        CRC32 checksum = new CRC32();
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        checksum.update(bytes, 0, bytes.length);
        return String.format("%08x", checksum.getValue());
    }

    private static String encoded(String text) {
        try {
            return URLEncoder.encode(text, "UTF-8");
        } catch (UnsupportedEncodingException e) {
            throw new IllegalStateException("every Java has UTF-8", e);
        }
    }

    private static String decoded(String text) {
        try {
            return URLDecoder.decode(text, "UTF-8");
        } catch (UnsupportedEncodingException e) {
            throw new IllegalStateException("every Java has UTF-8", e);
        }
    }
}
