package org.sami.crw.sim.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Whether standard error is a terminal. */
final class Terminal {
    private static final Path LINUX_STANDARD_ERROR = Path.of("/proc/self/fd/2");

    private Terminal() {}

    @SuppressWarnings("SystemConsoleNull") // SAMI runs on 17; on 22 and later it would take any stream for a terminal
    static boolean onStandardError() {
        String term = System.getenv("TERM");
        if (term == null || term.equals("dumb")) {
            return false;
        }
        if (Files.exists(LINUX_STANDARD_ERROR)) {
            try {
                String device = LINUX_STANDARD_ERROR.toRealPath().toString();
                return device.startsWith("/dev/pts/") || device.startsWith("/dev/tty");
            } catch (IOException e) {
                return false; // a pipe has no real path
            }
        }
        return System.console() != null;
    }
}
