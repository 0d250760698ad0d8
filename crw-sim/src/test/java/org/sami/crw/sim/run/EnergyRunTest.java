package org.sami.crw.sim.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.RunReport;
import org.sami.crw.sim.hull.Energy;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.crw.sim.run.settings.RunSettings;

/** What is promised of boats whose consumption depends on their speed is what they drive: judged by true batteries. */
class EnergyRunTest {
    /** A battery does not last for lanes of 50 m in 150 m, and for the way home, where instruments use four times as much as the motors. */
    @Test
    void operatorIsAskedByWhatHotelLoadLeavesAndNoBoatStopsDead() {
        RunReport report = TestRuns.run(
                TestRuns.plan("explore-area"),
                RunSettings.of(
                                "explore-area",
                                "Explore",
                                new FleetSettings(1, 1, 150, 1).with(Energy.parse("drag,hotel=900")))
                        .limitMillis(7_200_000)
                        .parameters(Map.of("@spacing", "50"))
                        .build());

        assertThat(report.decisions())
                .filteredOn(decision -> decision.type().equals("LongWay"))
                .singleElement()
                .satisfies(question -> assertThat(question.prompt()).startsWith("charges are sure to last for "));
        assertThat(report.result().outcome()).as(report.result().reason()).isEqualTo(RunOutcome.ENDED);
        assertThat(report.boats())
                .allSatisfy(
                        boat -> assertThat(boat.batteryPercent()).as(boat.id()).isBetween(0.1, 40.0));
    }
}
