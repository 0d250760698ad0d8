package org.sami.crw.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import org.sami.crw.cli.output.ExitCode;
import picocli.CommandLine;

/**
 * Does a little of everything that commands do, so that a process that archives its classes has loaded those that
 * commands need. The start script runs it, once for each Java. The layout of nets in layers is not among it: JDK 17 breaks when it
 * archives the lambdas of that library.
 */
final class ClassArchive {
    private ClassArchive() {}

    /** Runs it; the exit code is 0 where every command went well. */
    public static void main(String[] args) throws IOException {
        System.setProperty("java.awt.headless", "true");
        Path folder = Files.createTempDirectory("crw-classes");
        try {
            for (List<String> command : commands(folder)) {
                int code = execute(command);
                if (code != ExitCode.OK) {
                    System.exit(code);
                }
            }
        } finally {
            delete(folder);
        }
    }

    private static List<List<String>> commands(Path folder) {
        String journal = folder.resolve("journal").toString();
        String report = folder.resolve("report").toString();
        List<String> run = new ArrayList<>(
                List.of("run", "clv", "--boats", "2", "--locations", "2", "--area", "60", "--speed", "max"));
        run.addAll(List.of("--journal", journal, "--report", report));
        return List.of(
                List.of("--help"),
                List.of("check", "--help"),
                List.of("check", "clv"),
                List.of("plans"),
                List.of("test", "clv"),
                List.of("draw", "clv", "--png", folder.resolve("clv.png").toString()),
                List.of("events"),
                run,
                List.of("journal", journal));
    }

    private static int execute(List<String> command) {
        PrintWriter nowhere = new PrintWriter(Writer.nullWriter());
        CommandLine line = Crw.commandLine().setOut(nowhere).setErr(nowhere);
        return line.execute(command.toArray(String[]::new));
    }

    private static void delete(Path folder) throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
                Files.delete(file);
            }
        }
    }
}
