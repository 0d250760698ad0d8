package org.sami.crw.sim.console;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.Reader;
import java.util.Objects;
import java.util.Optional;

/** Lines of a script or a pipe. Each is written before its answer, so that what was printed can be read as a protocol. */
public final class PlainLines implements LineSource {
    private final BufferedReader in;
    private final PrintWriter out;

    public PlainLines(Reader in, PrintWriter out) {
        this.in = new BufferedReader(Objects.requireNonNull(in, "in"));
        this.out = Objects.requireNonNull(out, "out");
    }

    @Override
    public Optional<String> next() throws IOException {
        Optional<String> line = Optional.ofNullable(in.readLine());
        line.filter(text -> !text.isBlank()).ifPresent(text -> print("> " + text));
        return line;
    }

    @Override
    public void print(String line) {
        synchronized (out) {
            out.println(line);
            out.flush();
        }
    }

    /** Leaves both open: they are the process's. */
    @Override
    public void close() {
        out.flush();
    }
}
