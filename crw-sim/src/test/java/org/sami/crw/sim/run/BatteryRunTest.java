package org.sami.crw.sim.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.boat.link.BatteryDefaults;
import org.sami.crw.report.BoatResult;
import org.sami.crw.report.InterruptResult;
import org.sami.crw.report.LocationResult;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.RunReport;
import org.sami.crw.report.TrackPoint;
import org.sami.crw.service.reach.Range;
import org.sami.crw.sim.hull.Conditions;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.crw.sim.run.settings.InitialCharges;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.crw.sim.run.settings.RunSettings;

/** Boats whose batteries turn critical are pulled out (thesis 7.1.1): {@code recharge@battery}. */
@Tag("long")
class BatteryRunTest {
    @Test
    void boatIsPulledOutAtTheMomentAtWhichItTurnsCritical() {
        RunReport report = run("100,37,100", "recharge@battery");

        assertAllVisited(report);
        assertThat(report.interrupts()).singleElement().satisfies(pressed -> {
            assertThat(pressed.boat()).isEqualTo("boat2");
            assertThat(pressed.trigger()).isEqualTo(InterruptResult.BATTERY);
            assertThat(pressed.taken()).isTrue();
        });
        long pressed = report.interrupts().get(0).pressedAtMillis().getAsLong();
        List<TrackPoint> track = report.boats().get(1).track();
        assertThat(track)
                .filteredOn(p -> p.atMillis() < pressed - 2_000)
                .allMatch(p -> p.batteryPercent() >= criticalPercent(p, track.get(0)));
        assertThat(track)
                .filteredOn(p -> p.atMillis() >= pressed)
                .first()
                .satisfies(p -> assertThat(p.batteryPercent() - criticalPercent(p, track.get(0)))
                        .isBetween(-0.3, 0.0));
        assertThat(report.boats()).extracting(BoatResult::recharges).containsExactly(0, 1, 0);
    }

    @ParameterizedTest
    @ValueSource(strings = {"15", "100,15,15.1", "29.9", "30", "90"})
    void lowIsNotCritical(String charges) {
        RunReport report = TestRuns.run(plan(), settings(charges, 1, "recharge@battery"));

        // nobody drives before the allocation is accepted
        assertThat(report.interrupts())
                .allSatisfy(pressed ->
                        assertThat(pressed.pressedAtMillis().getAsLong()).isGreaterThan(15_000));
    }

    @Test
    void boatThatIsCriticalFromTheStartIsRechargedWhereItLies() {
        RunReport report = run("14.99", "recharge@battery");

        assertAllVisited(report);
        assertThat(report.interrupts()).hasSize(3).allMatch(InterruptResult::taken);
        assertThat(report.boats()).extracting(BoatResult::recharges).containsExactly(1, 1, 1);
    }

    @Test
    void boatThatIsCriticalAtLaunchIsPulledOutAsSoonAsItsPlanOffersIt() {
        RunReport report = run("100,14.99,100", "recharge:2@battery");

        InterruptResult pressed = report.interrupts().get(0);
        assertThat(pressed.boat()).isEqualTo("boat2");
        assertThat(pressed.pressedAtMillis().getAsLong()).isLessThan(1_000);
        assertThat(pressed.presses()).isGreaterThan(1);
        assertThat(pressed.takenAtMillis())
                .hasValue(report.firings().stream()
                        .filter(firing -> firing.transition().equals("Start recharge"))
                        .findFirst()
                        .orElseThrow()
                        .atMillis());
    }

    @ParameterizedTest
    @ValueSource(longs = {2, 4, 5, 8, 9, 10})
    void boatThatTurnsCriticalAnywhereInTheAreaComesBackToTheQuay(long seed) {
        RunPlan plan = plan();

        RunReport report =
                TestRuns.run(plan, TestRuns.settings(plan, 2, 100, seed).withInterrupts(List.of("recharge@battery")));

        assertThat(report.result().outcome()).as(report.result().reason()).isEqualTo(RunOutcome.ENDED);
        assertThat(report.locations()).hasSize(100).allMatch(LocationResult::visited);
        assertThat(report.interrupts()).isNotEmpty().allMatch(InterruptResult::taken);
    }

    @ParameterizedTest
    @ValueSource(strings = {"0s", "1s", "5s", "8s", "9s", "10s", "11s", "20s"})
    void swapEndsWhenTheBatteryIsIn(String swapTime) {
        RunPlan plan = plan();
        RunSettings settings = RunSettings.of(
                        plan.plan().id(),
                        plan.plan().name(),
                        new FleetSettings(3, 12, 600, 1).with(InitialCharges.parse("100,37,100")))
                .limitMillis(7_200_000)
                .parameters(java.util.Map.of("@swapTime", swapTime))
                .answerAfterMillis(0)
                .interrupts(List.of("recharge@battery"))
                .build();

        RunReport report = TestRuns.run(plan, settings);

        assertAllVisited(report);
        assertThat(report.boats()).extracting(BoatResult::recharges).containsExactly(0, 1, 0);
        long swapped = report.firings().stream()
                .filter(firing -> firing.transition().equals("Batteries swapped"))
                .findFirst()
                .orElseThrow()
                .atMillis();
        assertThat(report.boats().get(1).track())
                .filteredOn(point -> point.atMillis() > swapped)
                .first()
                .satisfies(leaving -> assertThat(leaving.batteryPercent()).isGreaterThan(99.9));
        assertThat(report.interrupts().get(0).takenAtMillis().getAsLong()).isLessThan(swapped);
    }

    /** A boat that holds its place against current and wind never lies still in the water: it is taken hold of at the quay. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void batteryIsSwappedInRoughWaterToo(long seed) {
        RunSettings settings = settings("100,37,100", 12, "recharge@battery");
        FleetSettings fleet = settings.fleet().on(Conditions.ROUGH).drawnFrom(seed);

        RunReport report = TestRuns.run(plan(), settings.withFleet(fleet));

        assertThat(report.result().outcome()).as(report.result().reason()).isEqualTo(RunOutcome.ENDED);
        assertThat(report.boats().get(1).recharges()).isPositive();
    }

    @Test
    void onlyTheNamedBoatIsPulledOut() {
        RunReport report = run("30,30,100", "recharge:1@battery");

        assertThat(report.interrupts())
                .isNotEmpty()
                .allMatch(pressed -> pressed.boat().equals("boat1"));
        assertThat(report.boats().get(0).recharges()).isEqualTo(1);
        assertThat(report.boats().get(1).recharges()).isZero();
    }

    @Test
    void boatThatTurnsCriticalAgainIsPulledOutAgain() {
        RunPlan plan = plan();
        RunSettings settings = RunSettings.of(
                        plan.plan().id(),
                        plan.plan().name(),
                        new FleetSettings(1, 120, 400, 3).with(InitialCharges.parse("25")))
                .limitMillis(20_000_000)
                .interrupts(List.of("recharge@battery"))
                .build();

        RunReport report = TestRuns.run(plan, settings);

        assertThat(report.result().outcome()).as(report.result().reason()).isEqualTo(RunOutcome.ENDED);
        assertThat(report.locations()).hasSize(120).allMatch(LocationResult::visited);
        assertThat(report.interrupts()).hasSizeGreaterThan(1).allMatch(InterruptResult::taken);
        assertThat(report.boats().get(0).recharges())
                .isEqualTo(report.interrupts().size());
    }

    /** Below this charge the boat's server calls the battery critical: a threshold, or the way home with its reserve. */
    private static double criticalPercent(TrackPoint at, TrackPoint home) {
        double wayM = Math.hypot(at.eastM() - home.eastM(), at.northM() - home.northM());
        return Math.max(
                BatteryDefaults.CRITICAL_PERCENT,
                BatteryDefaults.HOME_RESERVE_FACTOR * wayM / Range.METRES_PER_PERCENT);
    }

    private static RunReport run(String charges, String... interrupts) {
        return TestRuns.run(plan(), settings(charges, 12, interrupts));
    }

    private static RunPlan plan() {
        return TestRuns.plan("clv-interrupts");
    }

    private static RunSettings settings(String charges, int locations, String... interrupts) {
        RunPlan plan = plan();
        return RunSettings.of(
                        plan.plan().id(),
                        plan.plan().name(),
                        new FleetSettings(3, locations, 600, 1).with(InitialCharges.parse(charges)))
                .limitMillis(7_200_000)
                .interrupts(List.of(interrupts))
                .build();
    }

    private static void assertAllVisited(RunReport report) {
        assertThat(report.result().outcome()).as(report.result().reason()).isEqualTo(RunOutcome.ENDED);
        assertThat(report.locations()).hasSize(12).allMatch(LocationResult::visited);
    }
}
