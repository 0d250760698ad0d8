package org.sami.work.postgres.testing;

import io.zonky.test.db.postgres.embedded.EmbeddedPostgres;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.sami.journal.postgres.PostgresAddress;

/** A PostgreSQL server of one test, which fails as the test wants and is there again with what it had, at its port. It ends with the test. */
public final class DatabaseProcess implements AutoCloseable {
    private final Path data;
    private final List<ProcessHandle> killed = new ArrayList<>();
    private EmbeddedPostgres server;
    private boolean still;

    /**
     * Starts it.
     *
     * @param data its folder, which is made
     * @throws IOException if it does not start
     */
    public DatabaseProcess(Path data) throws IOException {
        this.data = data;
        server = builder().start();
    }

    private EmbeddedPostgres.Builder builder() {
        return EmbeddedPostgres.builder()
                .setOverrideWorkingDirectory(
                        Path.of("build", "postgres").toAbsolutePath().toFile())
                .setDataDirectory(data.toFile())
                .setCleanDataDirectory(false)
                .setPGStartupWait(Duration.ofMinutes(2));
    }

    /** Where a journal is made in it. */
    public PostgresAddress address() {
        return PostgresAddress.parse("postgresql://localhost:" + server.getPort() + "/postgres?user=postgres");
    }

    /**
     * Ends all its processes as {@code kill -9} does.
     *
     * @throws IOException if it does not run
     */
    public void kill() throws IOException {
        killed.addAll(processes());
        killed.forEach(ProcessHandle::destroyForcibly);
    }

    /**
     * Starts it again after it was killed.
     *
     * @throws IOException if it does not start
     */
    public void startAgain() throws IOException {
        killed.forEach(process -> process.onExit().join());
        killed.clear();
        int port = server.getPort();
        server.close();
        server = builder().setPort(port).start();
    }

    /**
     * Lets all its processes stand still, as where the machine or its disk answers nobody, or go on.
     *
     * @throws IOException if it does not run
     */
    public void standStill(boolean still) throws IOException, InterruptedException {
        this.still = still;
        for (ProcessHandle process : processes()) {
            new ProcessBuilder("kill", still ? "-STOP" : "-CONT", Long.toString(process.pid()))
                    .start()
                    .waitFor();
        }
    }

    private List<ProcessHandle> processes() throws IOException {
        String pid = Files.readAllLines(data.resolve("postmaster.pid")).get(0).strip();
        ProcessHandle first = ProcessHandle.of(Long.parseLong(pid)).orElseThrow();
        List<ProcessHandle> all = new ArrayList<>(List.of(first));
        all.addAll(first.descendants().toList());
        return all;
    }

    @Override
    public void close() throws IOException, InterruptedException {
        if (still) {
            standStill(false); // it would not end
        }
        server.close();
    }
}
