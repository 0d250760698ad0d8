package org.sami.boat.server.log;

import java.io.BufferedInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UnsupportedEncodingException;
import java.net.URLDecoder;
import java.net.URLEncoder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.regex.Pattern;
import java.util.zip.CRC32;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkException;
import org.sami.boat.link.LinkMessage;

/**
 * The lines of a boat's log. Their parts, divided by tabs, are a checksum of the rest of the line, the boat's time, the start of the server, the bodies of
 * the command and its answer as on the link, and the client's name in URL encoding. A line without bodies records a start, or how many lines were left
 * out; lines of earlier versions name no client.
 */
public final class LogLines {
    private static final Pattern BEGINNING = Pattern.compile("[0-9a-f]{8}\t|[0-9a-f]{0,8}$");

    private LogLines() {}

    /**
     * Reads a log; damaged lines are counted and skipped.
     *
     * @throws IOException if the file cannot be read, or is something else than a boat's log
     */
    public static LogExtent read(Path file, Consumer<LoggedCommand> entries) throws IOException {
        try (InputStream in = new BufferedInputStream(Files.newInputStream(file))) {
            ByteArrayOutputStream line = new ByteArrayOutputStream();
            long read = 0;
            long whole = 0;
            int unread = 0;
            for (int next = in.read(); next >= 0; next = in.read()) {
                read++;
                if (next == '\n') {
                    String text = new String(line.toByteArray(), StandardCharsets.UTF_8);
                    checkFirst(file, whole, text);
                    line.reset();
                    unread += take(text, entries) ? 0 : 1;
                    whole = read;
                } else {
                    line.write(next);
                }
            }
            checkFirst(file, whole, new String(line.toByteArray(), StandardCharsets.UTF_8));
            return new LogExtent(whole, unread);
        }
    }

    /** What begins otherwise than a log was never one, and is nobody's to cut off and write to. */
    private static void checkFirst(Path file, long before, String line) throws IOException {
        if (before == 0 && !BEGINNING.matcher(line).lookingAt()) {
            throw new IOException(file + " is no log of a boat");
        }
    }

    static String start(String bootId) {
        return checked("0\t" + bootId);
    }

    /** A line that counts changes of commander which were left out. */
    static String leftOut(String bootId, long timeMs, long count) {
        return checked(timeMs + "\t" + bootId + "\tleft out: " + count);
    }

    static String command(LoggedCommand entry) {
        return checked(entry.timeMs()
                + "\t"
                + entry.bootId()
                + "\t"
                + body(entry.command())
                + "\t"
                + body(entry.answer())
                + "\t"
                + encoded(entry.clientId()));
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

    /** Whether a line could be read: a start, or an entry, which is handed on. */
    private static boolean take(String line, Consumer<LoggedCommand> entries) {
        String[] parts = line.split("\t", 2);
        if (parts.length < 2 || !parts[0].equals(String.format("%08x", checksum(parts[1])))) {
            return false;
        }
        String[] fields = parts[1].split("\t", 5);
        if (fields.length < 4) {
            return true; // a start
        }
        Optional<LoggedCommand> entry = entry(fields);
        entry.ifPresent(entries);
        return entry.isPresent();
    }

    private static Optional<LoggedCommand> entry(String[] fields) {
        try {
            LinkMessage command = message(fields[2]);
            String clientId = fields.length < 5 ? "" : decoded(fields[4]);
            return command instanceof CommandMessage
                    ? Optional.of(new LoggedCommand(
                            fields[1],
                            Long.parseLong(fields[0]),
                            clientId,
                            (CommandMessage) command,
                            message(fields[3])))
                    : Optional.empty();
        } catch (LinkException | IllegalArgumentException e) {
            return Optional.empty(); // written by a server that knew other messages
        }
    }

    /** A message's JSON; it has no tab and no line end, as JSON escapes both. */
    private static String body(LinkMessage message) {
        return new String(LinkCodec.body(message), StandardCharsets.UTF_8);
    }

    private static String encoded(String clientId) {
        try {
            return URLEncoder.encode(clientId, "UTF-8");
        } catch (UnsupportedEncodingException e) {
            throw new IllegalStateException("every Java has UTF-8", e);
        }
    }

    private static String decoded(String clientId) {
        try {
            return URLDecoder.decode(clientId, "UTF-8");
        } catch (UnsupportedEncodingException e) {
            throw new IllegalStateException("every Java has UTF-8", e);
        }
    }

    private static LinkMessage message(String body) throws LinkException {
        return LinkCodec.readBody(body.getBytes(StandardCharsets.UTF_8));
    }
}
