package org.sami.crw.console;

import java.io.IOException;
import java.util.Optional;

/** Where typed lines come from, and where the console writes. */
public interface LineSource extends AutoCloseable {
    /** The next line; empty when there are no more. Waits for it. */
    Optional<String> next() throws IOException;

    /** Writes a line; from any thread, without spoiling a line that is being typed. */
    void print(String line);

    @Override
    void close() throws IOException;
}
