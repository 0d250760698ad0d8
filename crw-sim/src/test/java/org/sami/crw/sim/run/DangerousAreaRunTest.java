package org.sami.crw.sim.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.decision.AnswersFileReader;
import org.sami.crw.report.BoatResult;
import org.sami.crw.report.FiringResult;
import org.sami.crw.report.LocationResult;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.RunReport;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.crw.sim.run.settings.RunSettings;

/** Boats that go through a dangerous area one after another, in one shared sub-mission (thesis, Figure 7.4), with many seeds. */
@Tag("long")
class DangerousAreaRunTest {
    private static final int SEEDS = 40;
    private static final double MOST_DETOUR = 1.1;
    private static final Set<String> BEGINS = Set.of("Straight on", "Move single boat");
    private static final Set<String> ENDS =
            Set.of("Path done, next boat", "Out of danger, next boat", "Path failed, next boat");
    /** The middle of the square, 60 m wide. */
    private static final String ANSWERS = """
        {"format": "crw-answers", "version": 1, "rules": [{"event": "OperatorCreateArea", "answer": {"values": {"area": {"outline": [
         {"lat": 45.69973, "lon": 10.71961}, {"lat": 45.69973, "lon": 10.72039},
         {"lat": 45.70027, "lon": 10.72039}, {"lat": 45.70027, "lon": 10.71961}]}}}}]}\
        """;

    private static RunReport run(long seed, List<String> interrupts) {
        RunSettings settings = RunSettings.of(
                        "clv-dangerous-area", "clv-dangerous-area", new FleetSettings(3, 9, 120, seed))
                .limitMillis(7_200_000)
                .answers(ANSWERS)
                .interrupts(interrupts)
                .build();
        AnswersFile answers =
                AnswersFileReader.read(ANSWERS, TestRuns.LIBRARY.vocabulary()).orThrow();
        return new InProcessRun(TestRuns.plan("clv-dangerous-area"), settings, answers, RunJournal.none())
                .run(Pacer.UNPACED, RunObserver.NONE);
    }

    private static double distanceM(RunReport report) {
        return report.boats().stream().mapToDouble(BoatResult::distanceM).sum();
    }

    @Test
    void oneBoatAtATimeGoesThroughWithEverySeedAndGoesOnWhereItWas() {
        double withoutM = 0;
        double throughM = 0;
        int turns = 0;
        for (long seed = 1; seed <= SEEDS; seed++) {
            RunReport report = run(seed, List.of("traverse dangerous area@" + (35 + seed)));

            assertThat(report.result().outcome()).as("seed %s", seed).isEqualTo(RunOutcome.ENDED);
            assertThat(report.locations()).as("seed %s", seed).allMatch(LocationResult::visited);
            int inside = 0;
            for (FiringResult firing : report.firings()) {
                turns += BEGINS.contains(firing.transition()) ? 1 : 0;
                inside += BEGINS.contains(firing.transition()) ? 1 : 0;
                inside -= ENDS.contains(firing.transition()) ? 1 : 0;
                assertThat(inside).as("seed %s, %s", seed, firing).isBetween(0, 1);
            }
            assertThat(inside).as("seed %s", seed).isZero();
            throughM += distanceM(report);
            withoutM += distanceM(run(seed, List.of()));
        }
        assertThat(turns).isGreaterThan(2 * SEEDS);
        assertThat(throughM).isLessThan(MOST_DETOUR * withoutM);
    }
}
