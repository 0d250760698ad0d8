package org.sami.crw.sim.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.sim.fleet.SimulatedBoat;
import org.sami.crw.sim.hull.SimulatedHull;
import org.sami.crw.sim.report.LocationResult;
import org.sami.crw.sim.report.RunOutcome;
import org.sami.crw.sim.report.RunReport;

/** Twenty boats in calm water keep 3 m from one another in whole missions: measured ten times a second on where their hulls truly are. */
class SeparationRunTest {
    private static final double APART_M = 3;

    private InProcessRun run;
    private double leastM = Double.MAX_VALUE;
    private String nearest = "";

    private void look() {
        List<SimulatedBoat> boats = run.water().fleet().boats();
        for (int i = 0; i < boats.size(); i++) {
            for (int j = i + 1; j < boats.size(); j++) {
                SimulatedHull one = boats.get(i).hull();
                SimulatedHull other = boats.get(j).hull();
                double metres = Math.hypot(one.eastM() - other.eastM(), one.northM() - other.northM());
                if (metres < leastM) {
                    leastM = metres;
                    nearest = boats.get(i).id() + " and " + boats.get(j).id() + " at "
                            + run.water().clock().nowMs() + " ms";
                }
            }
        }
        run.water().clock().after(100, this::look);
    }

    /** How long these took before boats gave way, in seconds: 170, 283, 124, 195, 328. */
    @ParameterizedTest
    @CsvSource({
        "clv, 200, 100, '', 225",
        "explore-area, 300, 1, '', 365",
        "explore-area, 120, 1, '', 160",
        "station-keep, 200, 1, '', 250",
        "clv-interrupts, 200, 100, 'alarm@60;alarm over@150', 430"
    })
    void twentyBoatsKeepApartAndCompleteTheirMission(
            String id, double areaM, int locations, String interrupts, double withinS) {
        RunPlan plan = TestRuns.plan(id);
        RunSettings settings = TestRuns.settings(plan, 20, locations, 1)
                .withFleet(new RunSettings.Fleet(20, locations, areaM, 1))
                .withInterrupts(interrupts.isEmpty() ? List.of() : List.of(interrupts.split(";")));
        run = new InProcessRun(plan, settings, AnswersFile.EMPTY, RunJournal.none());
        run.water().clock().after(100, this::look);

        RunReport report = run.run(Pacer.UNPACED, RunObserver.NONE);

        assertThat(report.result().outcome()).isEqualTo(RunOutcome.ENDED);
        assertThat(report.locations()).allMatch(LocationResult::visited);
        assertThat(leastM).as(nearest).isGreaterThanOrEqualTo(APART_M);
        assertThat(report.result().simulatedMillis() / 1000.0).isLessThan(withinS);
    }
}
