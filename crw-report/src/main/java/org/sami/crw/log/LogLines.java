package org.sami.crw.log;

import java.io.BufferedInputStream;
import java.io.ByteArrayOutputStream;
import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;

/**
 * The lines of a file, one after the other; holds one line at a time, and of an endless one only its beginning. A line
 * ends with a line feed, with or without a carriage return before it.
 */
final class LogLines implements Closeable {
    /** The longest line that is kept; those of the boats are below 1,000. */
    static final int MOST_BYTES = 65_536;

    private static final int SAMPLE_BYTES = 4096;

    private final BufferedInputStream bytes;
    private long number;
    private long bytesRead;

    private LogLines(BufferedInputStream bytes) {
        this.bytes = bytes;
    }

    /**
     * A line of a file.
     *
     * @param number from 1
     * @param ended whether a line feed follows it
     * @param whole whether all of it is in the text
     */
    record Line(long number, String text, boolean ended, boolean whole) {}

    /**
     * Opens a file and looks at its beginning.
     *
     * @throws NotALogException if it is empty or no text
     */
    static LogLines open(Path file) throws IOException {
        InputStream raw = Files.newInputStream(file);
        try {
            BufferedInputStream bytes = new BufferedInputStream(raw, 2 * SAMPLE_BYTES);
            bytes.mark(SAMPLE_BYTES);
            byte[] head = bytes.readNBytes(SAMPLE_BYTES);
            bytes.reset();
            refuseWhatIsNoText(head);
            return new LogLines(bytes);
        } catch (IOException e) {
            raw.close();
            throw e;
        }
    }

    private static void refuseWhatIsNoText(byte[] head) throws NotALogException {
        if (head.length == 0) {
            throw new NotALogException("is empty");
        }
        for (int i = 0; i < head.length; i++) {
            int value = head[i] & 0xFF;
            boolean text = (value >= ' ' && value != 0x7F) || value == '\t' || value == '\n' || value == '\r';
            if (!text) {
                throw new NotALogException(String.format("is not a text file: byte %d is 0x%02X", i + 1, value));
            }
        }
    }

    /** The next line, or empty at the end of the file. */
    Optional<Line> next() throws IOException {
        ByteArrayOutputStream line = new ByteArrayOutputStream(160);
        boolean whole = true;
        int value = bytes.read();
        if (value < 0) {
            return Optional.empty();
        }
        while (value >= 0 && value != '\n') {
            bytesRead++;
            if (line.size() < MOST_BYTES) {
                line.write(value);
            } else {
                whole = false;
            }
            value = bytes.read();
        }
        if (value == '\n') {
            bytesRead++;
        }
        number++;
        String text = line.toString(StandardCharsets.UTF_8);
        String plain = text.endsWith("\r") ? text.substring(0, text.length() - 1) : text;
        return Optional.of(new Line(number, plain, value == '\n', whole));
    }

    /** How many bytes of the file were read so far. */
    long bytesRead() {
        return bytesRead;
    }

    @Override
    public void close() throws IOException {
        bytes.close();
    }
}
