package org.sami.journal.postgres;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.OptionalLong;

/** How long this machine has been on, with its sleep: what Linux says in a file. Nobody can set it. */
final class SinceBoot {
    private static final Path LINUX = Path.of("/proc/uptime");
    private static final double NANOS_A_SECOND = 1e9;

    private SinceBoot() {}

    /** In nanoseconds, in steps of 10 ms; empty where the system does not say it. */
    static OptionalLong nanos() {
        return nanos(LINUX);
    }

    /** What a file says whose first word is a time in seconds. */
    static OptionalLong nanos(Path file) {
        try {
            String text = Files.readString(file);
            return OptionalLong.of(Math.round(Double.parseDouble(text.split(" ", 2)[0]) * NANOS_A_SECOND));
        } catch (IOException | NumberFormatException other) {
            return OptionalLong.empty();
        }
    }
}
