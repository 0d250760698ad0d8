package org.sami.boat.mavlink;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Objects;

/**
 * Ground stations of other makers on this machine: those of the Python that the variable PYTHON names, or that {@code tools/ground-stations.sh} has installed, or
 * else the usual Python.
 */
final class StationPrograms {
    private static final Path INSTALLED = Path.of("../build/stations/bin/python");
    private static final String PYTHON = Objects.requireNonNullElse(
            System.getenv("PYTHON"),
            Files.isExecutable(INSTALLED) ? INSTALLED.toAbsolutePath().toString() : "python3");

    private StationPrograms() {}

    static String python() {
        return PYTHON;
    }

    /** Whether it has a module. */
    static boolean has(String module) throws Exception {
        try {
            return run(PYTHON, "-W", "ignore", "-c", "import " + module).isEmpty();
        } catch (IOException noPython) {
            return false;
        }
    }

    /** What to say where it has not. */
    static String missing(String module) {
        return "skipped: " + PYTHON + " has no " + module + " (tools/ground-stations.sh installs it)";
    }

    /** Runs a command to its end; what it printed, after {@code failed:} where it failed. */
    static String run(String... command) throws Exception {
        Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
        try (InputStream out = process.getInputStream()) {
            String text = new String(out.readAllBytes(), StandardCharsets.UTF_8);
            return process.waitFor() == 0 ? text : "failed: " + text;
        } finally {
            process.destroyForcibly();
        }
    }

    /** Runs a script of these tests to its end; what it printed. */
    static String runScript(String name, Path folder, String... arguments) throws Exception {
        Path script = folder.resolve(name);
        try (InputStream text = StationPrograms.class.getResourceAsStream(name)) {
            Files.write(script, text.readAllBytes());
        }
        String[] command = new String[arguments.length + 4];
        command[0] = PYTHON;
        command[1] = "-W";
        command[2] = "ignore";
        command[3] = script.toString();
        System.arraycopy(arguments, 0, command, 4, arguments.length);
        return run(command);
    }
}
