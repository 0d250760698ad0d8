package org.sami.dreamm;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;

/** The command of the boats that the build has installed, as a process of its own: DREAMM knows no boat. */
final class Crw {
    private static final int WITHIN_S = 300;

    private Crw() {}

    /** What became of a process: its exit code, and all that it said. */
    record Outcome(int code, String said) {}

    /** Runs it to its end; what it says goes to a file in the folder. */
    static Outcome run(Path folder, List<String> arguments) throws IOException, InterruptedException {
        List<String> command = new ArrayList<>();
        command.add(Path.of(System.getProperty("crw.installed"), "bin", "crw").toString());
        command.addAll(arguments);
        Path out = Files.createTempFile(folder, "crw", ".out");
        ProcessBuilder builder =
                new ProcessBuilder(command).redirectErrorStream(true).redirectOutput(out.toFile());
        builder.environment().remove("JAVA_TOOL_OPTIONS");
        builder.environment().put("JAVA_HOME", System.getProperty("java.home"));
        Process process = builder.start();
        try {
            assertThat(process.waitFor(WITHIN_S, TimeUnit.SECONDS))
                    .as("%s is over within %d s: %s", arguments, WITHIN_S, Files.readString(out))
                    .isTrue();
            return new Outcome(process.exitValue(), Files.readString(out));
        } finally {
            process.destroyForcibly();
        }
    }
}
