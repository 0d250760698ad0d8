package org.sami.crw.gui.robot;

import java.io.ByteArrayOutputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;

/** Hears what the program writes to standard error, which goes on to where it went before. */
final class ErrorWatch implements AutoCloseable {
    private final PrintStream before = System.err;
    private final ByteArrayOutputStream heard = new ByteArrayOutputStream();

    /** Hears it from now on. */
    ErrorWatch() {
        System.setErr(new PrintStream(new Both(), true, StandardCharsets.UTF_8));
    }

    /** The lines that belong to stack traces. */
    List<String> traces() {
        synchronized (heard) {
            return heard.toString(StandardCharsets.UTF_8)
                    .lines()
                    .filter(line -> line.startsWith("\tat ") || line.startsWith("Exception in thread"))
                    .toList();
        }
    }

    @Override
    public void close() {
        System.setErr(before);
    }

    private final class Both extends OutputStream {
        @Override
        public void write(int one) {
            before.write(one);
            synchronized (heard) {
                heard.write(one);
            }
        }

        @Override
        public void write(byte[] bytes, int from, int length) {
            before.write(bytes, from, length);
            synchronized (heard) {
                heard.write(bytes, from, length);
            }
        }

        @Override
        public void flush() {
            before.flush();
        }
    }
}
