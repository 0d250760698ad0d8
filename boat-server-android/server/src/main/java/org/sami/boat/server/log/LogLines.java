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
import java.util.regex.Pattern;
import java.util.zip.CRC32;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkException;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.server.RememberedCommand;

/**
 * The lines of a boat's log. Their parts, divided by tabs, are a checksum of the rest of the line, the boat's time, the start of the server, the bodies of
 * the command and its answer as on the link, and the client's name in URL encoding. A line without bodies records a start, or how many lines were left
 * out; lines of earlier versions name no client. A word in place of the command's body marks the lines with which a file after the first begins:
 * {@code carries} and their count, {@code known} for each command that the boat remembers, {@code in-force} for each that is in force; and then
 * {@code repeats} with the count of lines that stand in the file before as well.
 */
public final class LogLines {
    private static final Pattern BEGINNING = Pattern.compile("[0-9a-f]{8}\t|[0-9a-f]{0,8}$");
    private static final String LEFT_OUT = "left out: ";
    private static final String CARRIES = "carries";
    private static final String REPEATS = "repeats";
    private static final String KNOWN = "known";
    private static final String IN_FORCE = "in-force";
    private static final int KNOWN_FIELDS = 8;
    private static final int DIGEST_DIGITS = 64;

    private LogLines() {}

    /**
     * Reads a file of a log; damaged lines are counted and skipped.
     *
     * @throws IOException if the file cannot be read, or is something else than a boat's log
     */
    public static LogExtent read(Path file, LogEntries entries) throws IOException {
        return read(file, new Reading(entries, false), false);
    }

    /**
     * Reads a file after the one before it, and only what does not stand there as well.
     *
     * @throws IOException if the file cannot be read, or is something else than a boat's log
     */
    static LogExtent readOn(Path file, LogEntries entries) throws IOException {
        return read(file, new Reading(entries, true), false);
    }

    private static LogExtent read(Path file, Reading reading, boolean headOnly) throws IOException {
        try (InputStream in = new BufferedInputStream(Files.newInputStream(file))) {
            ByteArrayOutputStream line = new ByteArrayOutputStream();
            for (int next = in.read(); next >= 0 && !(headOnly && reading.isPastHead()); next = in.read()) {
                if (next == '\n') {
                    String text = new String(line.toByteArray(), StandardCharsets.UTF_8);
                    checkFirst(file, reading.wholeBytes, text);
                    reading.line(text, line.size() + 1);
                    line.reset();
                } else {
                    line.write(next);
                }
            }
            checkFirst(file, reading.wholeBytes, new String(line.toByteArray(), StandardCharsets.UTF_8));
            return reading.extent();
        }
    }

    /** Whether a file begins with all that a restarted boat needs of earlier ones. */
    static boolean isHeadWhole(Path file) throws IOException {
        return read(file, new Reading(entry -> {}, false), true).isHeadWhole();
    }

    /** How far a file has been read. */
    private static final class Reading {
        private final LogEntries entries;
        private final boolean onlyNew;
        private long wholeBytes;
        private int lines;
        private int unread;
        private int headLines = -1; // with the line that counts the others; -1 without a head
        private long headBytes;
        private int repeatedUntil;

        Reading(LogEntries entries, boolean onlyNew) {
            this.entries = entries;
            this.onlyNew = onlyNew;
        }

        void line(String text, int bytes) {
            wholeBytes += bytes;
            lines++;
            if (lines == 1) {
                headLines = 1 + count(text, CARRIES);
            } else if (onlyNew && count(text, REPEATS) > 0) {
                repeatedUntil = lines + count(text, REPEATS);
            }
            boolean known = onlyNew && lines <= Math.max(headLines, repeatedUntil);
            unread += known || take(text, entries) ? 0 : 1;
            if (lines == headLines) {
                headBytes = wholeBytes;
            }
        }

        boolean isPastHead() {
            return lines > 0 && lines >= headLines;
        }

        LogExtent extent() {
            return new LogExtent(wholeBytes, unread, headLines > 0 && lines >= headLines, headBytes);
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
        return checked(timeMs + "\t" + bootId + "\t" + LEFT_OUT + count);
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

    /** The first line of a file after the first: so many lines follow that carry the state. */
    static String begins(String bootId, int count) {
        return checked("0\t" + bootId + "\t" + CARRIES + "\t" + count);
    }

    /** A line after the head of a file: so many lines follow that stand in the file before as well. */
    static String repeats(String bootId, int count) {
        return checked("0\t" + bootId + "\t" + REPEATS + "\t" + count);
    }

    static String remembered(String bootId, RememberedCommand command) {
        StringBuilder digest = new StringBuilder(DIGEST_DIGITS);
        for (byte next : command.digest()) {
            digest.append(Character.forDigit((next >> 4) & 0xf, 16)).append(Character.forDigit(next & 0xf, 16));
        }
        return checked("0\t" + bootId + "\t" + KNOWN + "\t" + body(command.answer()) + "\t"
                + encoded(command.clientId()) + "\t" + encoded(command.commandId()) + "\t"
                + (command.isTransfer() ? "transfer" : "command") + "\t" + digest);
    }

    static String inForce(String bootId, String clientId, CommandMessage command) {
        return checked("0\t" + bootId + "\t" + IN_FORCE + "\t" + body(command) + "\t" + encoded(clientId));
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

    /** The parts of an undamaged line after its checksum; none of another. */
    private static String[] fields(String line) {
        String[] parts = line.split("\t", 2);
        boolean undamaged = parts.length == 2 && parts[0].equals(String.format("%08x", checksum(parts[1])));
        return undamaged ? parts[1].split("\t", KNOWN_FIELDS) : new String[0];
    }

    static boolean isUndamaged(String line) {
        return fields(line).length > 1;
    }

    /** How many lines a line of this word counts; -2 for another line. */
    private static int count(String line, String word) {
        if (!line.contains(word)) {
            return -2;
        }
        String[] fields = fields(line);
        try {
            return fields.length == 4 && fields[2].equals(word) ? Math.max(0, Integer.parseInt(fields[3])) : -2;
        } catch (NumberFormatException e) {
            return -2;
        }
    }

    /** Whether a line could be read: its content is handed on. */
    private static boolean take(String line, LogEntries entries) {
        String[] fields = fields(line);
        try {
            if (fields.length < 2) {
                return false;
            } else if (fields.length == 2) {
                entries.started(fields[1]);
            } else if (fields.length == 3) {
                boolean count = fields[2].startsWith(LEFT_OUT);
                long lines = count ? Long.parseLong(fields[2].substring(LEFT_OUT.length())) : 0;
                entries.leftOut(fields[1], Long.parseLong(fields[0]), lines);
            } else if (fields.length == 4 && (fields[2].equals(CARRIES) || fields[2].equals(REPEATS))) {
                return true; // counts lines
            } else if (fields[2].equals(KNOWN) && fields.length == KNOWN_FIELDS) {
                entries.remembered(remembered(fields));
            } else if (fields[2].equals(IN_FORCE) && fields.length == 5) {
                LinkMessage command = message(fields[3]);
                if (command instanceof CommandMessage) {
                    entries.inForce(decoded(fields[4]), (CommandMessage) command);
                }
            } else {
                Optional<LoggedCommand> entry = entry(fields);
                entry.ifPresent(entries::answered);
                return entry.isPresent();
            }
            return true;
        } catch (LinkException | IllegalArgumentException e) {
            return false; // written by a server that knew other messages
        }
    }

    private static RememberedCommand remembered(String[] fields) throws LinkException {
        byte[] digest = new byte[fields[7].length() / 2];
        for (int i = 0; i < digest.length; i++) {
            digest[i] = (byte) Integer.parseInt(fields[7].substring(2 * i, 2 * i + 2), 16);
        }
        return new RememberedCommand(
                decoded(fields[4]), decoded(fields[5]), fields[6].equals("transfer"), digest, message(fields[3]));
    }

    private static Optional<LoggedCommand> entry(String[] fields) throws LinkException {
        LinkMessage command = message(fields[2]);
        String clientId = fields.length < 5 ? "" : decoded(fields[4]);
        return command instanceof CommandMessage
                ? Optional.of(new LoggedCommand(
                        fields[1], Long.parseLong(fields[0]), clientId, (CommandMessage) command, message(fields[3])))
                : Optional.empty();
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
