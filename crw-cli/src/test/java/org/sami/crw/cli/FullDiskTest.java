package org.sami.crw.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Runs whose disk is full at some moment, and has room again when they are taken up. */
@Timeout(900)
@Tag("process")
class FullDiskTest {
    private static final List<String> MISSION =
            List.of("run", "clv", "--boats", "3", "--locations", "8", "--speed", "max", "--json");

    private static final int MISSIONS = 200;

    private static String undisturbed;

    @TempDir
    private Path folder;

    @BeforeAll
    static void runUndisturbed() throws Exception {
        CommandResult ran = CommandResult.crw(MISSION.toArray(String[]::new));
        assertThat(ran.exitCode()).as(ran.err()).isZero();
        undisturbed = hash(ran.out());
    }

    private static String hash(String report) throws IOException {
        return new ObjectMapper().readTree(report).path("runHash").asText();
    }

    /** A limit of the size of files, as a quota sets it: needs no rights. */
    @Test
    void runThatMayWriteNoMoreEndsAndIsTakenUpToTheSameEnd() throws Exception {
        assumeThat(Path.of("/bin/bash")).as("ulimit of bash").exists();
        Path library = folder.resolve("libsqlitejdbc.so"); // larger than the limit: not to be unpacked under it
        assumeThat(unpacked(library)).as("SQLite's library for Linux").isTrue();
        int interrupted = 0;
        for (int kib = 136; kib <= 264; kib += 64) {
            Path journal = folder.resolve("limit" + kib + ".journal");
            ProcessBuilder limited = CrwProcess.command(folder, mission(journal));
            limited.command().addAll(0, List.of("/bin/bash", "-c", "ulimit -f " + kib + "; exec \"$@\"", "bash"));
            limited.environment()
                    .put(
                            "JAVA_OPTS",
                            "-Dorg.sqlite.lib.path=" + folder + " -Dorg.sqlite.lib.name=" + library.getFileName());

            Said said = run(limited);

            if (said.isInterrupted(journal)) {
                interrupted++;
                assertThat(said.text()).contains("cannot be written");
                assertThat(takenUp(journal)).as("%d KiB", kib).isEqualTo(undisturbed);
            }
        }
        assertThat(interrupted).as("runs that were interrupted under way").isGreaterThan(1);
    }

    /** The console's session has a script, so nobody is there to make room. */
    @Test
    void consoleWhoseJournalMayGrowNoMoreSaysSoAndEndsWithExitCode4() throws Exception {
        assertThat(Path.of("/bin/bash"))
                .as("the shell whose ulimit is the limit")
                .exists();
        List<String> commands = new ArrayList<>(List.of("add anna 45.4,10.9", "wait boats 1 within 60"));
        for (int i = 0; i < MISSIONS; i++) {
            commands.add("start clv");
            commands.add("abort all");
        }
        commands.add("health");
        commands.add("quit");
        Path script = Files.write(folder.resolve("script"), commands);
        Path library = folder.resolve("libsqlitejdbc.so");
        assertThat(unpacked(library)).as("SQLite's library for this machine").isTrue();
        Path journal = folder.resolve("console.journal");
        ProcessBuilder limited = CrwProcess.command(
                folder, List.of("session", "--script", script.toString(), "--journal", journal.toString()));
        limited.command().addAll(0, List.of("/bin/bash", "-c", "ulimit -f 900; exec \"$@\"", "bash"));
        limited.environment()
                .put(
                        "JAVA_OPTS",
                        "-Dorg.sqlite.lib.path=" + folder + " -Dorg.sqlite.lib.name=" + library.getFileName());

        Said said = run(limited);

        assertThat(said.exitCode()).as(said.text()).isEqualTo(4);
        assertThat(said.text())
                .contains("Missions stand still; the journal cannot be written")
                .contains("Boats that were under way for missions hold their places");
    }

    /** A real disk of a few hundred KiB: root alone can mount one. */
    @Test
    void runWhoseDiskIsFullEndsAndIsTakenUpToTheSameEndOnceThereIsRoom() throws Exception {
        Path disk = Files.createDirectory(folder.resolve("disk"));
        int interrupted = 0;
        for (int kib = 292; kib <= 388; kib += 48) {
            boolean mounted = exitCode("mount", "-t", "tmpfs", "-o", "size=" + kib + "k", "none", disk.toString()) == 0;
            assumeThat(mounted).as("a small disk can be mounted here").isTrue();
            try {
                Path journal = disk.resolve("journal");
                Said said = run(CrwProcess.command(folder, mission(journal)));
                if (!said.isInterrupted(journal)) {
                    continue;
                }
                interrupted++;
                assertThat(said.text()).contains("full");
                CommandResult tooEarly = CommandResult.crw("resume", journal.toString(), "--speed", "max", "--json");
                assertThat(tooEarly.exitCode()).isIn(0, 4);

                assertThat(exitCode("mount", "-o", "remount,size=64m", disk.toString()))
                        .isZero();

                assertThat(takenUp(journal)).as("%d KiB", kib).isEqualTo(undisturbed);
            } finally {
                assertThat(exitCode("umount", disk.toString())).isZero();
            }
        }
        assertThat(interrupted).as("runs that were interrupted under way").isGreaterThan(1);
    }

    private static String takenUp(Path journal) throws IOException {
        CommandResult resumed = CommandResult.crw("resume", journal.toString(), "--speed", "max", "--json");
        assertThat(resumed.exitCode()).as(resumed.err()).isZero();
        return hash(resumed.out());
    }

    private static boolean unpacked(Path library) throws IOException {
        String architecture = System.getProperty("os.arch").equals("amd64") ? "x86_64" : System.getProperty("os.arch");
        String name = "/org/sqlite/native/" + System.getProperty("os.name") + "/" + architecture + "/libsqlitejdbc.so";
        try (InputStream in = FullDiskTest.class.getResourceAsStream(name)) {
            return in != null && Files.copy(in, library) > 0;
        }
    }

    private static List<String> mission(Path journal) {
        List<String> mission = new ArrayList<>(MISSION);
        mission.addAll(List.of("--journal", journal.toString()));
        return mission;
    }

    /** What a run said that may have found no room: at its start, under way, or not at all. */
    private record Said(int exitCode, String text) {
        /** Whether it ended for want of room with a journal begun; with too little for the beginning it leaves none. */
        boolean isInterrupted(Path journal) {
            assertThat(exitCode).as(text).isIn(0, 4);
            assertThat(exitCode == 0 && !Files.exists(journal)).as(text).isFalse();
            return exitCode == 4 && Files.exists(journal);
        }
    }

    private Said run(ProcessBuilder command) throws Exception {
        Path output = folder.resolve("output");
        Process process = command.redirectErrorStream(true)
                .redirectOutput(output.toFile())
                .start();
        assertThat(process.waitFor(240, TimeUnit.SECONDS)).isTrue();
        String said = Files.readString(output);
        return new Said(process.exitValue(), said);
    }

    private static int exitCode(String... command) throws Exception {
        try {
            Process process = new ProcessBuilder(command)
                    .redirectErrorStream(true)
                    .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                    .start();
            return process.waitFor();
        } catch (IOException missing) {
            return -1;
        }
    }
}
