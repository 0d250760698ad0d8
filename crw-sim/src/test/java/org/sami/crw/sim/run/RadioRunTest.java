package org.sami.crw.sim.run;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.RunReport;
import org.sami.crw.sim.link.Radio;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.crw.sim.run.settings.RunSettings;

/** Runs in process over a radio: one of three boats has a location about 140 m from the quay. */
class RadioRunTest {
    @Test
    void boatOutOfRangeHoldsAndItsMissionCannotEnd() {
        RunReport report = run("range=90", 3_600_000);

        assertThat(report.result().outcome()).isEqualTo(RunOutcome.FAILED);
        assertThat(report.boats())
                .filteredOn(boat -> boat.link().lost() > 0)
                .singleElement()
                .satisfies(boat -> {
                    assertThat(boat.link().reconnected()).isZero();
                    assertThat(boat.link().words()).isEqualTo("in-process, radio loss=0,range=90");
                    assertThat(boat.link().why()).contains("holds its place");
                });
    }

    @Test
    void boatThatReturnsHasItsLinkBackAndSetsOutAgain() {
        RunReport report = run("range=90,lost-link=return", 300_000);

        assertThat(report.result().outcome()).isEqualTo(RunOutcome.RUNNING);
        assertThat(report.boats())
                .filteredOn(boat -> boat.link().lost() > 0)
                .singleElement()
                .satisfies(boat -> assertThat(boat.link().reconnected()).isGreaterThan(2));
    }

    @Test
    void boatThatContinuesVisitsWhatIsBeyondTheRadio() {
        RunReport report = run("range=90,lost-link=continue", 300_000);

        assertThat(report.locations())
                .allSatisfy(location -> assertThat(location.visit()).isPresent());
    }

    @Test
    void missionEndsOverARadioThatLosesMessagesAndEqualSettingsGiveEqualRuns() {
        RunReport once = run("loss=30", 3_600_000);
        RunReport again = run("loss=30", 3_600_000);

        assertThat(once.result().outcome()).isEqualTo(RunOutcome.ENDED);
        assertThat(again.result().runHash()).isEqualTo(once.result().runHash());
        assertThat(once.result().runHash())
                .isNotEqualTo(run("loss=0", 3_600_000).result().runHash());
    }

    private static RunReport run(String radio, long limitMillis) {
        return TestRuns.run(
                TestRuns.plan("clv"),
                RunSettings.of("clv", "Visit", new FleetSettings(3, 6, 120, 1).over(Radio.parse(radio)))
                        .limitMillis(limitMillis)
                        .build());
    }
}
