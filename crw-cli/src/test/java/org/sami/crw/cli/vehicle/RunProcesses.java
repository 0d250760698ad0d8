package org.sami.crw.cli.vehicle;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import org.sami.crw.cli.Crw;
import org.sami.spn.testing.JavaProcess;

/** Processes of {@code crw} that command vehicles, each with a name, and what they say. Those that live are killed at the end. */
final class RunProcesses implements AutoCloseable {
    private final Path folder;
    private final Pattern visited;
    private final List<Process> started = new ArrayList<>();

    /** Those of runs with so many locations, with their files in a test's folder. */
    RunProcesses(Path folder, int locations) {
        this.folder = folder;
        visited = Pattern.compile("visited (\\d+)/" + locations);
    }

    /** Starts one. */
    Process crw(String name, String... arguments) throws IOException {
        ProcessBuilder builder = JavaProcess.builder(folder, Crw.class, arguments);
        List<String> line = new ArrayList<>(builder.command());
        line.add(1, "-Dsami.vehicles=" + folder.resolve("vehicles"));
        Process process = builder.command(line)
                .redirectOutput(folder.resolve(name + ".out").toFile())
                .redirectError(folder.resolve(name + ".err").toFile())
                .start();
        started.add(process);
        return process;
    }

    /** How many locations are visited, as a process says every few seconds. */
    int visitedBy(String name) {
        return visited.matcher(saidBy(name))
                .results()
                .mapToInt(found -> Integer.parseInt(found.group(1)))
                .max()
                .orElse(0);
    }

    /** What a process has said of its progress. */
    String saidBy(String name) {
        try {
            return Files.readString(folder.resolve(name + ".err"));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @Override
    public void close() {
        started.forEach(Process::destroyForcibly);
    }
}
