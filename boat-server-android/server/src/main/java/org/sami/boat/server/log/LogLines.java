package org.sami.boat.server.log;

import java.io.BufferedInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.zip.CRC32;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkException;
import org.sami.boat.link.LinkMessage;

/**
 * The lines of a boat's log: a checksum of the rest of the line, the boat's time, the start of the server, and the bodies of
 * the command and of its answer as they are on the link, between tabs. A line without bodies tells of a start.
 */
public final class LogLines {
    private static final LinkCodec CODEC = new LinkCodec();
    private static final int HEADER_BYTES = LinkCodec.LENGTH_BYTES + 1;

    private LogLines() {}

    /**
     * Reads a log.
     *
     * @return the length in bytes up to the end of the last whole line; what stands behind it was cut off
     */
    public static long read(Path file, Consumer<LoggedCommand> entries) throws IOException {
        try (InputStream in = new BufferedInputStream(Files.newInputStream(file))) {
            ByteArrayOutputStream line = new ByteArrayOutputStream();
            long read = 0;
            long whole = 0;
            for (int next = in.read(); next >= 0; next = in.read()) {
                read++;
                if (next == '\n') {
                    String text = new String(line.toByteArray(), StandardCharsets.UTF_8);
                    line.reset();
                    entry(text).ifPresent(entries); // a line that was damaged says nothing
                    whole = read;
                } else {
                    line.write(next);
                }
            }
            return whole;
        }
    }

    static String start(String bootId) {
        return checked("0\t" + bootId);
    }

    static String command(LoggedCommand entry) {
        return checked(
                entry.timeMs() + "\t" + entry.bootId() + "\t" + body(entry.command()) + "\t" + body(entry.answer()));
    }

    private static String checked(String rest) {
        return String.format("%08x", checksum(rest)) + "\t" + rest + "\n";
    }

    private static long checksum(String text) {
        CRC32 checksum = new CRC32();
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        checksum.update(bytes, 0, bytes.length);
        return checksum.getValue();
    }

    private static Optional<LoggedCommand> entry(String line) {
        String[] parts = line.split("\t", 2);
        if (parts.length < 2 || !parts[0].equals(String.format("%08x", checksum(parts[1])))) {
            return Optional.empty();
        }
        String[] fields = parts[1].split("\t", 4);
        if (fields.length < 4) {
            return Optional.empty(); // a start
        }
        try {
            LinkMessage command = message(fields[2]);
            return command instanceof CommandMessage
                    ? Optional.of(new LoggedCommand(
                            fields[1], Long.parseLong(fields[0]), (CommandMessage) command, message(fields[3])))
                    : Optional.empty();
        } catch (LinkException | NumberFormatException e) {
            return Optional.empty(); // written by a server that knew other messages
        }
    }

    /** A message's JSON; it has no tab and no line end, as JSON escapes both. */
    private static String body(LinkMessage message) {
        byte[] frame = CODEC.encode(0, message);
        return new String(frame, HEADER_BYTES, frame.length - HEADER_BYTES, StandardCharsets.UTF_8);
    }

    private static LinkMessage message(String body) throws LinkException {
        byte[] bytes = body.getBytes(StandardCharsets.UTF_8);
        ByteBuffer frame = ByteBuffer.allocate(HEADER_BYTES + bytes.length);
        frame.putInt(1 + bytes.length).put((byte) LinkCodec.VERSION).put(bytes);
        return CODEC.decode(frame.array()).message();
    }
}
