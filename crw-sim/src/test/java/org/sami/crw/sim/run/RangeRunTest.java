package org.sami.crw.sim.run;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.crw.report.DecisionResult;
import org.sami.crw.report.LocationResult;
import org.sami.crw.report.NoteResult;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.RunReport;
import org.sami.crw.sim.run.settings.InitialCharges;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.crw.sim.run.settings.RunSettings;

/** Charges are taken into account when locations are divided: no boat stops dead on its way. */
class RangeRunTest {
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5})
    void noBoatIsSentFartherThanItsChargeLastsWhereOthersCanGo(long seed) {
        RunReport report = run("100,14,100", seed);

        assertThat(report.result().outcome()).as(report.result().reason()).isEqualTo(RunOutcome.ENDED);
        assertThat(report.locations()).hasSize(20).allMatch(LocationResult::visited);
        assertThat(report.boats())
                .allSatisfy(
                        boat -> assertThat(boat.batteryPercent()).as(boat.id()).isPositive());
        assertThat(report.decisions()).extracting(DecisionResult::type).doesNotContain("LongWay");
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2})
    void operatorIsAskedBeforeTheStartWhereNoDivisionIsWithinTheCharges(long seed) {
        RunReport report = run("8,8,8", seed);

        assertThat(report.decisions()).extracting(DecisionResult::type).contains("LongWay");
        assertThat(report.notes())
                .extracting(NoteResult::message)
                .anyMatch(text -> text.startsWith("Allocation: ") && text.contains("is sure to last for 255 m"));
    }

    @Test
    void operatorIsAskedBeforeAnAreaIsExploredThatChargesDoNotLastFor() {
        RunReport asked = run("explore-area", "12,100,100", 1);

        assertThat(asked.decisions())
                .filteredOn(decision -> decision.type().equals("LongWay"))
                .singleElement()
                .satisfies(question ->
                        assertThat(question.prompt()).startsWith("charges are sure to last for 82 % of the area: "));
    }

    private static RunReport run(String charges, long seed) {
        return run("clv", charges, seed);
    }

    private static RunReport run(String planId, String charges, long seed) {
        RunPlan plan = TestRuns.plan(planId);
        RunSettings settings = RunSettings.of(
                        plan.plan().id(),
                        plan.plan().name(),
                        new RunSettings.Fleet(3, 20, 600, seed).with(InitialCharges.parse(charges)))
                .limitMillis(7_200_000)
                .build();
        return TestRuns.run(plan, settings);
    }
}
