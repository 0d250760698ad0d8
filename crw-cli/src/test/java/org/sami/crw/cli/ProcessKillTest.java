package org.sami.crw.cli;

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
    private static final double SPEED = 160;

    /** How much slower the next run is where one was killed too late: in the end no machine is too slow to see it in time. */
    private static final double SLOWER = 8;

    /** A kill counts where less than this share of the journal was written after the place it was meant for. */
    private static final double LATE_SHARE = 0.25;

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
        Path wholeJournal = folder.resolve("whole");
        String whole = hash(
                CommandResult.crw(with(mission, "--speed", "max", "--json", "--journal", wholeJournal.toString())));
        long entries = JournalEntries.in(wholeJournal);
        Random random = new Random(9);
        ExecutorService lanes = Executors.newFixedThreadPool(LANES);
        try {
            List<Future<Long>> deaths = new ArrayList<>();
            for (int i = 0; i < KILLS; i++) {
                Path place = Files.createDirectory(folder.resolve("kill" + i));
                double share = (i + random.nextDouble()) / KILLS;
                deaths.add(lanes.submit(() -> killedAndTakenUp(mission, place, share, entries, whole)));
            }
            Set<Long> resumedFrom = new TreeSet<>();
            for (Future<Long> death : deaths) {
                resumedFrom.add(death.get());
            }

            assertThat(resumedFrom).as("different places of death").hasSizeGreaterThanOrEqualTo(Math.min(3, KILLS / 4));
        } finally {
            lanes.shutdownNow();
        }
    }

    /**
     * Kills a run once its journal holds this share of the whole run's entries, and takes it up.
     *
     * @return after which entry it died
     */
    private static long killedAndTakenUp(List<String> mission, Path place, double share, long entries, String whole)
            throws Exception {
        long from = 1 + (long) ((entries - 2) * share);
        long tooLate = Math.min(entries, from + (long) (entries * LATE_SHARE));
        for (double speed = SPEED; ; speed /= SLOWER) {
            Path journal = place.resolve("journal-" + speed);
            try (CrwProcess run = CrwProcess.start(
                    place, List.of(with(mission, "--speed", "" + speed, "--journal", journal.toString())))) {
                run.awaitErr("journal");
                JournalEntries.killAt(from, journal, run);
            }

            CommandResult resumed = CommandResult.crw("resume", journal.toString(), "--speed", "max", "--json");

            assertThat(resumed.exitCode()).as(resumed.err()).isZero();
            long died = new ObjectMapper()
                    .readTree(resumed.out())
                    .get("resumedFrom")
                    .asLong();
            assertThat(hash(resumed)).as("killed after entry %d", died).isEqualTo(whole);
            assertThat(died).as("what was seen in the journal is there").isGreaterThanOrEqualTo(from);
            if (died < tooLate) {
                return died;
            }
        }
    }

    @Test
    void realProcessGivesTheSameRunAndExitCode() throws Exception {
        List<String> mission =
                List.of("run", "clv", "--boats", "2", "--locations", "4", "--area", "150", "--speed", "max", "--json");
        Process process = CrwProcess.command(folder, mission)
                .redirectError(folder.resolve("err").toFile())
                .start();

        String out = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);

        assertThat(process.waitFor()).isZero();
        assertThat(hash(new CommandResult(0, out, "")))
                .isEqualTo(hash(CommandResult.crw(mission.toArray(String[]::new))));
    }

    @Test
    void realProcessReportsWrongUsage() throws Exception {
        Process process = CrwProcess.command(folder, List.of("run", "clv", "--boats", "0"))
                .redirectErrorStream(true)
                .start();

        String out = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);

        assertThat(process.waitFor()).isEqualTo(2);
        assertThat(out).contains("--boats is 1 to 250, not 0");
    }

    @Test
    void interruptedProcessLeavesAJournalAndSaysHowToGoOn() throws Exception {
        Path journal = folder.resolve("interrupted");
        Process process = CrwProcess.command(
                        folder,
                        List.of(
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
