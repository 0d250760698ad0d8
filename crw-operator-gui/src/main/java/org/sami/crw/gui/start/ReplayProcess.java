package org.sami.crw.gui.start;

import java.io.BufferedReader;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.sami.ui.look.Look;

/** Starts a replay during a session: in a process of its own, so that nothing in it slows the session down (docs/replay.md). */
public final class ReplayProcess {
    /** The program of the windows, which stands above this package. */
    private static final String PROGRAM = "org.sami.crw.gui.OperatorGui";

    private ReplayProcess() {}

    /**
     * Starts it, in the theme and scale in force, with the options of Java that this process has: so it starts from the same archive of classes.
     *
     * @param folder the data directory of the session's window
     * @param problem receives in one line why the process has ended with a fault, such as that the file is no journal; on a thread of its own
     * @throws IOException if this machine starts no process
     */
    public static void start(Path journal, Path folder, Consumer<String> problem) throws IOException {
        List<String> line = new ArrayList<>();
        line.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        ManagementFactory.getRuntimeMXBean().getInputArguments().stream()
                .filter(option -> option.startsWith("-X"))
                .forEach(line::add);
        line.addAll(List.of(
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
                Integer.toString(Look.scalePercent())));
        Process process = new ProcessBuilder(line)
                .redirectOutput(ProcessBuilder.Redirect.INHERIT)
                .start();
        Thread listening = new Thread(() -> listen(process, problem), "replay-errors");
        listening.setDaemon(true);
        listening.start();
    }

    /** Passes on what the process says on its standard error; the last line is why it ended, where it ended with a fault. */
    private static void listen(Process process, Consumer<String> problem) {
        String last = "it ended without a word";
        try (BufferedReader said = process.errorReader()) {
            for (String line = said.readLine(); line != null; line = said.readLine()) {
                System.err.println(line);
                last = line;
            }
            if (process.waitFor() != 0) {
                problem.accept(last.replaceFirst("^crw-operator: ", ""));
            }
        } catch (IOException gone) {
            problem.accept("it cannot be listened to any longer: " + gone.getMessage());
        } catch (InterruptedException ends) {
            Thread.currentThread().interrupt();
        }
    }
}
