package org.sami.crw.cli.output;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.Writer;
import org.sami.crw.console.TerminalText;

/**
 * Whatever a command prints, made safe for a terminal ({@link TerminalText}): the one place that all output of {@code crw} passes. Only a line of
 * progress is written over, by {@link #CLEAR_LINE}. Safe for use by several threads.
 */
public final class TerminalWriter extends PrintWriter {
    /** Lets what follows be written over the line; obeyed only where it is printed by itself, as this very object. */
    static final String CLEAR_LINE = "\r\u001b[K";

    private final PrintWriter target;

    private TerminalWriter(PrintWriter target) {
        super(new Shown(target), true);
        this.target = target;
    }

    /** The same output, made safe; one that is safe already stays as it is. */
    public static PrintWriter of(PrintWriter target) {
        return target instanceof TerminalWriter ? target : new TerminalWriter(target);
    }

    @Override
    @SuppressWarnings("ReferenceEquality") // a name of the same letters must not clear a line
    public void print(String text) {
        if (text == CLEAR_LINE) {
            flush();
            target.print(CLEAR_LINE);
        } else {
            super.print(text);
        }
    }

    /** A line end may come in two parts, so a carriage return waits for what follows. */
    private static final class Shown extends Writer {
        private final PrintWriter target;
        private boolean returned;

        Shown(PrintWriter target) {
            super(target);
            this.target = target;
        }

        @Override
        public void write(char[] text, int offset, int length) {
            StringBuilder shown = new StringBuilder(length);
            for (int i = offset; i < offset + length; i++) {
                char letter = text[i];
                if (returned) {
                    returned = false;
                    if (letter == '\n') {
                        shown.append('\r');
                    } else {
                        TerminalText.append('\r', shown);
                    }
                }
                if (letter == '\r') {
                    returned = true;
                } else if (TerminalText.isObeyed(letter)) {
                    TerminalText.append(letter, shown);
                } else {
                    shown.append(letter);
                }
            }
            target.write(shown.toString());
        }

        @Override
        public void flush() {
            target.flush();
        }

        @Override
        public void close() throws IOException {
            target.close();
        }
    }
}
