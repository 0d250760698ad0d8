package org.sami.crw.cli.output;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.Writer;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.regex.Pattern;

/**
 * Standard error, line by line: passed on, or only what is wrong, and all whole lines into a log as well. What is wrong begins with
 * {@code crw:}, or is a finding, as whatever commands write.
 */
public final class ErrorLines extends Writer {
    private static final Pattern FAULT = Pattern.compile("crw: .*|Try '.*|.*: error [A-Z]-.*");

    private final PrintWriter target;
    private final boolean quiet;
    private final PrintWriter log;
    private final StringBuilder line = new StringBuilder();

    public ErrorLines(PrintWriter target, boolean quiet, PrintWriter log) {
        this.target = target;
        this.quiet = quiet;
        this.log = log;
    }

    @Override
    public void write(char[] text, int offset, int length) {
        if (!quiet) {
            target.write(text, offset, length);
        }
        for (int i = offset; i < offset + length; i++) {
            if (text[i] == '\n') {
                end();
            } else if (text[i] == '\r') {
                line.setLength(0); // a line of progress that is overwritten
            } else {
                line.append(text[i]);
            }
        }
    }

    /** Takes what was written so far for a line. */
    public void end() {
        String whole = line.toString();
        line.setLength(0);
        if (whole.isBlank()) {
            return;
        }
        if (quiet && FAULT.matcher(whole).matches()) {
            target.println(whole);
        }
        log.println(now() + " " + whole);
        flush();
    }

    /** The time as the log has it. */
    private static String now() {
        return Instant.now().truncatedTo(ChronoUnit.MILLIS).toString();
    }

    @Override
    public void flush() {
        target.flush();
        log.flush();
    }

    @Override
    public void close() throws IOException {
        end();
    }
}
