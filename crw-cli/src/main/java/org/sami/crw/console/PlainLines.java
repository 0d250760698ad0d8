package org.sami.crw.console;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.Reader;
import java.util.Objects;
import java.util.Optional;
import org.sami.spn.json.FileTooLargeException;

/** Lines of a script or a pipe. Each is written before its answer, so that what was printed can be read as a protocol. */
public final class PlainLines implements LineSource {
    private static final int LONGEST_LINE = 1_000_000;

    private final BufferedReader in;
    private final PrintWriter out;
    private final String name;

    /** @param name of what is read, for people */
    public PlainLines(String name, Reader in, PrintWriter out) {
        this.name = name;
        this.in = new BufferedReader(Objects.requireNonNull(in, "in"));
        this.out = Objects.requireNonNull(out, "out");
    }

    @Override
    public Optional<String> next() throws IOException {
        Optional<String> line = read();
        line.filter(text -> !text.isBlank()).ifPresent(text -> print("> " + text));
        return line;
    }

    /** As a buffered reader does, but a line has an end: a device that gives none would fill the memory. */
    private Optional<String> read() throws IOException {
        StringBuilder line = new StringBuilder();
        int next = in.read();
        boolean ended = next < 0;
        while (next >= 0 && next != '\n') {
            if (line.length() == LONGEST_LINE) {
                throw new FileTooLargeException(
                        name + ": a line of more than " + LONGEST_LINE + " characters is no command");
            }
            line.append((char) next);
            next = in.read();
        }
        int last = line.length() - 1;
        if (last >= 0 && line.charAt(last) == '\r') {
            line.setLength(last);
        }
        return ended ? Optional.empty() : Optional.of(line.toString());
    }

    @Override
    public void print(String line) {
        synchronized (out) {
            out.println(TerminalText.shown(line));
            out.flush();
        }
    }

    /** Leaves both open: they are the process's. */
    @Override
    public void close() {
        out.flush();
    }
}
