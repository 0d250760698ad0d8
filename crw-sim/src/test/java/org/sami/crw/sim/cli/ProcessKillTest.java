package org.sami.crw.sim.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.BufferedReader;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.sim.run.TestRuns;

/** Real processes of {@code crw run}, killed as by {@code kill -9}, and what the next process makes of their journals. */
@Tag("process")
class ProcessKillTest {
    private static final int KILLS = Integer.getInteger("crw.kills", 8);

    /** Each lane kills one run after another. */
    private static final int LANES = 2;

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
        ExecutorService lanes = Executors.newFixedThreadPool(LANES);
        try {
            List<Future<Fate>> fates = new ArrayList<>();
            for (int i = 0; i < KILLS; i++) {
                Path place = Files.createDirectory(folder.resolve("kill" + i));
                long after = (long) (LATEST_KILL_MILLIS * (i + random.nextDouble()) / KILLS);
                fates.add(lanes.submit(() -> killedAndTakenUp(mission, place, after, whole)));
            }
            int killed = 0;
            Set<Long> resumedFrom = new TreeSet<>();
            for (Future<Fate> fate : fates) {
                killed += fate.get().killed() ? 1 : 0;
                resumedFrom.add(fate.get().resumedFrom());
            }

            assertThat(killed).as("runs that were still alive").isGreaterThanOrEqualTo(KILLS / 2);
            assertThat(resumedFrom).as("different places of death").hasSizeGreaterThanOrEqualTo(KILLS / 4);
        } finally {
            lanes.shutdownNow();
        }
    }

    /** What became of one run. */
    private record Fate(boolean killed, long resumedFrom) {}

    private static Fate killedAndTakenUp(List<String> mission, Path place, long afterMillis, String whole)
            throws Exception {
        String journal = place.resolve("journal").toString();
        boolean killed;
        try (CrwProcess run = CrwProcess.start(place, List.of(with(mission, "--speed", SPEED, "--journal", journal)))) {
            run.awaitErr("journal");
            killed = !run.endsWithin(afterMillis);
            run.kill();
        }

        CommandResult resumed = CommandResult.crw("resume", journal, "--speed", "max", "--json");

        assertThat(resumed.exitCode()).as(resumed.err()).isZero();
        assertThat(hash(resumed)).as("killed after %d ms", afterMillis).isEqualTo(whole);
        return new Fate(
                killed,
                new ObjectMapper().readTree(resumed.out()).get("resumedFrom").asLong());
    }

    @Test
    void realProcessGivesTheSameRunAndExitCode() throws Exception {
        List<String> mission =
                List.of("run", "clv", "--boats", "2", "--locations", "4", "--area", "150", "--speed", "max", "--json");
        Process process = CrwProcess.command(mission)
                .redirectError(folder.resolve("err").toFile())
                .start();

        String out = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);

        assertThat(process.waitFor()).isZero();
        assertThat(hash(new CommandResult(0, out, "")))
                .isEqualTo(hash(CommandResult.crw(mission.toArray(String[]::new))));
    }

    @Test
    void realProcessReportsWrongUsage() throws Exception {
        Process process = CrwProcess.command(List.of("run", "clv", "--boats", "0"))
                .redirectErrorStream(true)
                .start();

        String out = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);

        assertThat(process.waitFor()).isEqualTo(2);
        assertThat(out).contains("--boats is 1 to 250, not 0");
    }

    @Test
    void interruptedProcessLeavesAJournalAndSaysHowToGoOn() throws Exception {
        Path journal = folder.resolve("interrupted");
        Process process = CrwProcess.command(List.of(
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
                        journal.toString()))
                .redirectErrorStream(true)
                .start();
        try (BufferedReader lines =
                new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8))) {
            assertThat(lines.readLine()).contains("if this process dies: crw resume " + journal);
            assertThat(lines.readLine()).startsWith("running clv");
            process.toHandle().destroy(); // the signal of an ordinary end, as Ctrl-C is

            assertThat(lines.lines()).anyMatch(line -> line.contains("crw resume " + journal));
        }
        process.waitFor();
        assertThat(CommandResult.crw("resume", journal.toString(), "--speed", "max")
                        .exitCode())
                .isZero();
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
