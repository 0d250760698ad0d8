package org.sami.crw.sim.tcp;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.sami.crw.sim.boat.Await;
import org.sami.crw.sim.cli.Crw;

/** A process of the command {@code crw} of its own, which does not outlive its test. What it says goes to files. */
final class CrwProcess implements AutoCloseable {
    private static final double START_S = 60;

    private final Process process;
    private final Path out;
    private final Path err;

    private CrwProcess(Process process, Path out, Path err) {
        this.process = process;
        this.out = out;
        this.err = err;
    }

    /** Starts it; {@code folder} takes what it says. */
    static CrwProcess start(Path folder, List<String> arguments) throws IOException {
        List<String> command = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-cp",
                System.getProperty("java.class.path"),
                "-Djava.awt.headless=true",
                "-XX:TieredStopAtLevel=1",
                "-XX:+UseSerialGC",
                Crw.class.getName()));
        command.addAll(arguments);
        Path out = Files.createTempFile(folder, "process", ".out");
        Path err = Files.createTempFile(folder, "process", ".err");
        Process process = new ProcessBuilder(command)
                .redirectOutput(out.toFile())
                .redirectError(err.toFile())
                .start();
        return new CrwProcess(process, out, err);
    }

    String out() {
        return text(out);
    }

    String err() {
        return text(err);
    }

    private static String text(Path file) {
        try {
            return Files.readString(file, StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    boolean isAlive() {
        return process.isAlive();
    }

    /** Waits until it has said something on standard error. */
    void awaitErr(String words) {
        Await.until("it says '" + words + "'", START_S, () -> err().contains(words) || !isAlive());
        assertThat(err()).contains(words);
    }

    /** Waits until it has said a line that begins so on standard output; returns the rest of the line. */
    String awaitOut(String beginning) {
        Await.until("a line", START_S, () -> out().contains("\n") || !isAlive());
        String line = out().lines().findFirst().orElse("");
        assertThat(line).as(err()).startsWith(beginning);
        return line.substring(beginning.length());
    }

    /** Ends it as {@code kill -9} does. */
    void kill() throws InterruptedException {
        process.destroyForcibly().waitFor();
    }

    /** Tells it to end, as {@code kill} and the system's shutdown do. */
    void terminate() {
        process.toHandle().destroy();
    }

    /** Waits so long for its end; returns whether it came. */
    boolean endsWithin(long millis) throws InterruptedException {
        return process.waitFor(millis, TimeUnit.MILLISECONDS);
    }

    /** Waits for its end; returns its exit code. */
    int await(long seconds) throws InterruptedException {
        assertThat(process.waitFor(seconds, TimeUnit.SECONDS))
                .as("over within %d s: %s", seconds, err())
                .isTrue();
        return process.exitValue();
    }

    @Override
    public void close() {
        process.destroyForcibly();
    }
}
