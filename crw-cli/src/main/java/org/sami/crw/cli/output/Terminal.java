package org.sami.crw.cli.output;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Whether the streams of this process are a terminal. */
public final class Terminal {
    private static final Path LINUX_STREAMS = Path.of("/proc/self/fd");

    private Terminal() {}

    /** Whether progress is shown at a terminal. */
    public static boolean onStandardError() {
        return is(2);
    }

    /** Whether a person types the input and sees the output. */
    public static boolean onStandardInputAndOutput() {
        return is(0) && is(1);
    }

    @SuppressWarnings("SystemConsoleNull") // SAMI runs on 17; on 22 and later it would take any stream for a terminal
    private static boolean is(int stream) {
        String term = System.getenv("TERM");
        if (term == null || term.equals("dumb")) {
            return false;
        }
        Path link = LINUX_STREAMS.resolve(String.valueOf(stream));
        if (Files.exists(link)) {
            try {
                String device = link.toRealPath().toString();
                return device.startsWith("/dev/pts/") || device.startsWith("/dev/tty");
            } catch (IOException e) {
                return false; // a pipe has no real path
            }
        }
        return System.console() != null;
    }
}
