package org.sami.crw.sim.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.OptionalLong;
import java.util.TreeMap;
import javax.management.ObjectName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.decision.AnswersFileReader;
import org.sami.crw.report.RunReport;
import org.sami.crw.sim.resume.RunRecord;
import org.sami.crw.sim.resume.WrittenJournal;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.spn.journal.JournalReader;
import org.sami.spn.json.ProjectWriter;

/** Hours of a run: what it holds in memory stays the same, and the journal holds what is worth keeping. */
@Tag("long")
@Isolated("counts the objects of the process")
@Timeout(900)
class LongRunTest {
    private static final long HOUR_MS = 3_600_000;
    private static final long LIMIT_MS = 4 * HOUR_MS + 60_000; // the boats' places are looked at every 20 s
    private static final String NEVER_END = "{\"format\": \"crw-answers\", \"version\": 1,"
            + " \"rules\": [{\"event\": \"OperatorApprove\", \"answer\": {\"yes\": false}}]}";

    @TempDir
    private Path folder;

    @Test
    void holdsNoMoreObjectsAfterFourHoursThanAfterTwo() {
        RunPlan plan = TestRuns.plan("station-keep");
        InProcessRun run = new InProcessRun(plan, settings(plan), answers(), RunJournal.none());
        Map<Integer, Map<String, Long>> counts = countEveryHour(run);

        RunReport report = run.run(Pacer.UNPACED, RunObserver.NONE);

        assertThat(report.result().simulatedMillis()).isEqualTo(LIMIT_MS);
        assertThat(report.result().firings()).isGreaterThan(4000);
        assertThat(report.firings()).hasSize((int) report.result().firings());
        assertThat(report.decisions()).hasSizeGreaterThan(50);
        Map<String, Long> first = counts.get(2);
        Map<String, Long> last = counts.get(4);
        last.forEach((name, count) ->
                assertThat(count).as(name).isLessThanOrEqualTo(first.getOrDefault(name, 0L) * 11 / 10 + 600));
    }

    @Test
    void journalKeepsTheNewestSnapshotsAndEveryTwentieth() throws Exception {
        RunPlan plan = TestRuns.plan("station-keep");
        Path file = folder.resolve("hours.journal");
        RunSettings settings = settings(plan);
        RunRecord record = new RunRecord(
                settings,
                "station-keep",
                new ProjectWriter(TestRuns.LIBRARY.vocabulary()).text(plan.project()),
                TestRuns.LIBRARY.files().texts());
        try (WrittenJournal journal = WrittenJournal.create(file, record)) {
            new InProcessRun(plan, settings, answers(), journal).run(Pacer.UNPACED, RunObserver.NONE);
        }

        try (JournalReader reader = JournalReader.open(file)) {
            assertThat(Files.size(file) / reader.lastIndex())
                    .as("bytes of an entry, with its share of snapshots, marks and the header")
                    .isLessThan(250);
        }
    }

    private static RunSettings settings(RunPlan plan) {
        return TestRuns.settings(plan, 5, 1, 3).withLimit(OptionalLong.of(LIMIT_MS));
    }

    private static AnswersFile answers() {
        return AnswersFileReader.read(NEVER_END, TestRuns.LIBRARY.vocabulary()).orThrow();
    }

    private static Map<Integer, Map<String, Long>> countEveryHour(InProcessRun run) {
        Map<Integer, Map<String, Long>> counts = new TreeMap<>();
        run.addListener((index, atMillis, input, effects, view) -> {
            int hour = (int) (atMillis / HOUR_MS);
            if (hour > 0 && !counts.containsKey(hour)) {
                counts.put(hour, liveObjects());
            }
        });
        return counts;
    }

    /** How many objects of each of the project's classes are alive. */
    private static Map<String, Long> liveObjects() {
        Map<String, Long> counts = new LinkedHashMap<>();
        for (String line : histogram().split("\n")) {
            String[] words = line.strip().split("\\s+");
            if (words.length >= 4 && words[3].startsWith("org.sami.")) {
                counts.merge(words[3], Long.parseLong(words[1]), Long::sum);
            }
        }
        assertThat(counts).isNotEmpty();
        return counts;
    }

    private static String histogram() {
        try {
            return (String) ManagementFactory.getPlatformMBeanServer()
                    .invoke(
                            new ObjectName("com.sun.management:type=DiagnosticCommand"),
                            "gcClassHistogram",
                            new Object[] {null},
                            new String[] {String[].class.getName()});
        } catch (Exception e) {
            throw new IllegalStateException("this Java platform counts no objects", e);
        }
    }
}
