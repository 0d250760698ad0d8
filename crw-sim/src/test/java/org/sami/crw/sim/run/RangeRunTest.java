package org.sami.crw.sim.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sami.crw.report.DecisionResult;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.RunReport;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.crw.sim.run.settings.RunSettings;

/** What is promised of boats with another range than usual is what they drive: judged by true batteries. */
class RangeRunTest {
    /** Three batteries of 1.5 km do not last for lanes of 50 m in 400 m; three of 3.5 km do. */
    @Test
    void operatorIsAskedByTheRangeThatBoatsSay() {
        RunReport report = explored(1500);

        assertThat(report.decisions())
                .filteredOn(decision -> decision.type().equals("LongWay"))
                .singleElement()
                .satisfies(question ->
                        assertThat(question.prompt()).startsWith("charges are sure to last for 90 % of the area: "));
    }

    @Test
    void noBoatStopsDeadWhoseRangeIsShort() {
        RunReport report = explored(1500);

        assertThat(report.result().outcome()).as(report.result().reason()).isEqualTo(RunOutcome.ENDED);
        assertThat(report.boats())
                .allSatisfy(
                        boat -> assertThat(boat.batteryPercent()).as(boat.id()).isPositive());
    }

    @Test
    void boatsWithALongRangeAreNotAskedAbout() {
        assertThat(explored(10_000).decisions())
                .extracting(DecisionResult::type)
                .doesNotContain("LongWay");
    }

    private static RunReport explored(double rangeM) {
        return TestRuns.run(
                TestRuns.plan("explore-area"),
                RunSettings.of("explore-area", "Explore", new FleetSettings(3, 1, 400, 1).withRangeM(rangeM))
                        .limitMillis(7_200_000)
                        .parameters(Map.of("@spacing", "50"))
                        .build());
    }
}
