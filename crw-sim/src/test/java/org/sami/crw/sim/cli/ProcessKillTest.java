package org.sami.crw.sim.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.BufferedReader;
import java.io.File;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.sim.run.TestRuns;

/** Real processes of {@code crw run}, killed as by {@code kill -9}, and what the next process makes of their journals. */
class ProcessKillTest {
    private static final int KILLS = 20;

    /** At this speed the sample's several simulated minutes take about a second and a half. */
    private static final String SPEED = "160";

    private static final long LATEST_KILL_MILLIS = 1_200;

    @TempDir
    Path folder;

    @Test
    void killedAndResumedRunsEndAsTheUninterruptedOne() throws Exception {
        Path project = Files.writeString(folder.resolve("sample.json"), TestRuns.text("sample-project.json"));
        Path answers = Files.writeString(folder.resolve("answers.json"), TestRuns.text("sample-answers.json"));
        List<String> mission = List.of(
                "run",
                project.toString(),
                "--boats",
                "3",
                "--locations",
                "5",
                "--area",
                "120",
                "--seed",
                "11",
                "--answers",
                answers.toString());
        String whole = hash(CommandResult.crw(with(mission, "--speed", "max", "--json")));
        Random random = new Random(9);
        TreeSet<Long> resumedFrom = new TreeSet<>();
        int killed = 0;

        for (int i = 0; i < KILLS; i++) {
            Path journal = folder.resolve("kill-" + i);
            long after = (long) (random.nextDouble() * LATEST_KILL_MILLIS);
            killed += runAndKill(with(mission, "--speed", SPEED, "--journal", journal.toString()), after) ? 1 : 0;

            CommandResult resumed = CommandResult.crw("resume", journal.toString(), "--speed", "max", "--json");

            assertThat(resumed.exitCode()).as(resumed.err()).isZero();
            assertThat(hash(resumed)).as("killed after %d ms", after).isEqualTo(whole);
            resumedFrom.add(new ObjectMapper()
                    .readTree(resumed.out())
                    .get("resumedFrom")
                    .asLong());
        }

        assertThat(killed).as("runs that were still alive").isGreaterThanOrEqualTo(KILLS / 2);
        assertThat(resumedFrom).as("different places of death").hasSizeGreaterThanOrEqualTo(5);
    }

    @Test
    void realProcessGivesTheSameRunAndExitCode() throws Exception {
        List<String> mission =
                List.of("run", "clv", "--boats", "2", "--locations", "4", "--area", "150", "--speed", "max", "--json");
        Process process = new ProcessBuilder(command(mission))
                .redirectError(folder.resolve("err").toFile())
                .start();

        String out = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);

        assertThat(process.waitFor()).isZero();
        assertThat(hash(new CommandResult(0, out, "")))
                .isEqualTo(hash(CommandResult.crw(mission.toArray(String[]::new))));
    }

    @Test
    void realProcessReportsWrongUsage() throws Exception {
        Process process = new ProcessBuilder(command(List.of("run", "clv", "--boats", "0")))
                .redirectErrorStream(true)
                .start();

        String out = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);

        assertThat(process.waitFor()).isEqualTo(2);
        assertThat(out).contains("--boats is 1 to 250, not 0");
    }

    @Test
    void interruptedProcessLeavesAJournalAndSaysHowToGoOn() throws Exception {
        Path journal = folder.resolve("interrupted");
        Process process = new ProcessBuilder(command(List.of(
                        "run",
                        "clv",
                        "--boats",
                        "2",
                        "--locations",
                        "4",
                        "--area",
                        "150",
                        "--speed",
                        "5",
                        "--journal",
                        journal.toString())))
                .redirectErrorStream(true)
                .start();
        try (BufferedReader lines =
                new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8))) {
            lines.readLine();
            process.waitFor(700, TimeUnit.MILLISECONDS);
            process.toHandle().destroy(); // the signal of an ordinary end, as Ctrl-C is

            assertThat(lines.lines()).anyMatch(line -> line.contains("crw resume " + journal));
        }
        process.waitFor();
        assertThat(CommandResult.crw("resume", journal.toString(), "--speed", "max")
                        .exitCode())
                .isZero();
    }

    /** Whether there was somebody to kill. */
    private boolean runAndKill(String[] mission, long afterMillis) throws Exception {
        Process process = new ProcessBuilder(command(List.of(mission)))
                .redirectOutput(folder.resolve("out").toFile())
                .start();
        try (BufferedReader err =
                new BufferedReader(new InputStreamReader(process.getErrorStream(), StandardCharsets.UTF_8))) {
            assertThat(err.readLine()).contains("journal");
            boolean ended = process.waitFor(afterMillis, TimeUnit.MILLISECONDS);
            process.destroyForcibly().waitFor();
            return !ended;
        }
    }

    private static List<String> command(List<String> args) {
        List<String> command = new ArrayList<>();
        command.add(System.getProperty("java.home") + File.separator + "bin" + File.separator + "java");
        command.addAll(
                List.of("-XX:TieredStopAtLevel=1", "-Xshare:auto", "-cp", System.getProperty("java.class.path")));
        command.add(Crw.class.getName());
        command.addAll(args);
        return command;
    }

    private static String[] with(List<String> mission, String... more) {
        List<String> all = new ArrayList<>(mission);
        all.addAll(List.of(more));
        return all.toArray(String[]::new);
    }

    private static String hash(CommandResult ran) throws Exception {
        return new ObjectMapper().readTree(ran.out()).get("runHash").asText();
    }
}
