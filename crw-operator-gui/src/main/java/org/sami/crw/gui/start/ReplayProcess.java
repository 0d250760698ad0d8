package org.sami.crw.gui.start;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.sami.ui.look.Look;

/** Starts a replay beside a session: in a process of its own, so that nothing in it slows the session down (docs/decisions/0250). */
public final class ReplayProcess {
    /** The program of the windows, which stands above this package. */
    private static final String PROGRAM = "org.sami.crw.gui.OperatorGui";

    private ReplayProcess() {}

    /**
     * Starts it, in the theme and scale in force.
     *
     * @param folder the data directory of the session's window
     * @throws IOException if this machine starts no process
     */
    public static void start(Path journal, Path folder) throws IOException {
        String java = Path.of(System.getProperty("java.home"), "bin", "java").toString();
        List<String> line = List.of(
                java,
                "-XX:+UseSerialGC",
                "-cp",
                System.getProperty("java.class.path"),
                PROGRAM,
                "--replay",
                journal.toAbsolutePath().toString(),
                "--data",
                folder.toAbsolutePath().toString(),
                "--theme",
                Look.theme().id(),
                "--scale",
                Integer.toString(Look.scalePercent()));
        new ProcessBuilder(line).inheritIO().start();
    }
}
