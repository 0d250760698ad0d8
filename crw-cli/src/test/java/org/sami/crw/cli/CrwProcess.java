package org.sami.crw.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.sami.boat.server.testing.Await;
import org.sami.spn.testing.JavaProcess;

/** A process of the installed command {@code crw}, which does not outlive its test. What it says goes to files. */
public final class CrwProcess implements AutoCloseable {
    /** Where the build has installed the command; its archive of classes makes a process start in a third of the time. */
    static final Path INSTALLED = Path.of(System.getProperty("crw.installed"));

    private final Process process;
    private final Path out;
    private final Path err;

    private CrwProcess(Process process, Path out, Path err) {
        this.process = process;
        this.out = out;
        this.err = err;
    }

    /** How the command is started: by its script, which becomes the process, on the Java of the test; {@code folder} is the test's. */
    static ProcessBuilder command(Path folder, List<String> arguments) throws IOException {
        return command(List.of(), folder, arguments);
    }

    private static ProcessBuilder command(List<String> before, Path folder, List<String> arguments) throws IOException {
        List<String> command = new ArrayList<>(before);
        command.add(INSTALLED.resolve("bin").resolve("crw").toString());
        command.addAll(arguments);
        ProcessBuilder builder = new ProcessBuilder(command);
        prepare(builder.environment(), folder);
        return builder;
    }

    /** Puts the Java of the test into an environment, with temporary files in the test's folder, and what a JVM would speak of out of it. */
    static void prepare(Map<String, String> environment, Path folder) throws IOException {
        environment.merge("CRW_OPTS", JavaProcess.temporaryFilesIn(folder), (before, more) -> before + " " + more);
        environment.remove("JAVA_TOOL_OPTIONS");
        environment.put("JAVA_HOME", System.getProperty("java.home"));
        environment.put("XDG_CACHE_HOME", INSTALLED.resolveSibling("cache").toString());
    }

    /** Starts it; {@code folder} takes what it says. */
    public static CrwProcess start(Path folder, List<String> arguments) throws IOException {
        return startBy(List.of(), folder, arguments);
    }

    /** The same, by a command that runs it somewhere else, such as in another network. */
    public static CrwProcess startBy(List<String> before, Path folder, List<String> arguments) throws IOException {
        Path out = Files.createTempFile(folder, "process", ".out");
        Path err = Files.createTempFile(folder, "process", ".err");
        Process process = command(before, folder, arguments)
                .redirectOutput(out.toFile())
                .redirectError(err.toFile())
                .start();
        return new CrwProcess(process, out, err);
    }

    /** What it has said on standard output. */
    public String out() {
        return text(out);
    }

    /** What it has said on standard error. */
    public String err() {
        return text(err);
    }

    private static String text(Path file) {
        try {
            return Files.readString(file, StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Whether it runs. */
    public boolean isAlive() {
        return process.isAlive();
    }

    /** Waits until it has said something on standard error. */
    public void awaitErr(String words) {
        Await.until("it says '" + words + "'", () -> err().contains(words) || !isAlive());
        assertThat(err()).contains(words);
    }

    /** Waits until it has said a line that begins so on standard output; returns the rest of the line. */
    public String awaitOut(String beginning) {
        Await.until("a line", () -> out().contains("\n") || !isAlive());
        String line = out().lines().findFirst().orElse("");
        assertThat(line).as(err()).startsWith(beginning);
        return line.substring(beginning.length());
    }

    /** Ends it as {@code kill -9} does. */
    public void kill() throws InterruptedException {
        process.destroyForcibly().waitFor();
    }

    /** Its number in the system. */
    long pid() {
        return process.pid();
    }

    /** Lets it stand still, as on a machine that does nothing any more, or go on. */
    public void standStill(boolean still) throws IOException, InterruptedException {
        new ProcessBuilder("kill", still ? "-STOP" : "-CONT", Long.toString(pid()))
                .start()
                .waitFor();
    }

    /** Tells it to end, as {@code kill} and the system's shutdown do. */
    public void terminate() {
        process.toHandle().destroy();
    }

    /** Waits for its end; returns its exit code. */
    public int await(long seconds) throws InterruptedException {
        assertThat(process.waitFor(seconds, TimeUnit.SECONDS))
                .as("over within %d s: %s", seconds, err())
                .isTrue();
        return process.exitValue();
    }

    /** Kills it where it still runs; then it writes no more into the test's folder. */
    @Override
    public void close() {
        process.destroyForcibly();
        process.onExit().join();
    }
}
