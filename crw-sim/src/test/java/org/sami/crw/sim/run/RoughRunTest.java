package org.sami.crw.sim.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.RunReport;
import org.sami.crw.sim.hull.Conditions;
import org.sami.crw.sim.hull.Flow;
import org.sami.crw.sim.hull.SensorSetting;
import org.sami.crw.sim.run.record.ReadingRecorder;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.session.record.SensorValue;
import org.sami.spn.value.GeoPoint;

/** Whole missions in current, wind and noise, with sensors. */
class RoughRunTest {
    private static final Conditions ROUGH = new Conditions(
            0.5,
            3,
            Flow.parse("0.3@90"),
            Flow.parse("4@270"),
            List.of(SensorSetting.parse("temperature"), SensorSetting.parse("oxygen@0.1")));

    private static RunReport run(Conditions conditions, long seed) {
        RunPlan plan = TestRuns.plan("clv");
        RunSettings settings = RunSettings.of("clv", "clv", new FleetSettings(2, 6, 300, seed).on(conditions))
                .limitMillis(7_200_000)
                .build();
        return TestRuns.run(plan, settings);
    }

    @Test
    void missionEndsAndTheReportHoldsWhatTheBoatsMeasured() {
        RunReport report = run(ROUGH, 3);

        assertThat(report.result().outcome()).isEqualTo(RunOutcome.ENDED);
        long expected = 2 * report.result().simulatedMillis() / 1000;
        assertThat(report.readings().stream().filter(r -> r.channel().equals("temperature")))
                .hasSizeBetween((int) expected - 6, (int) expected + 6)
                .allMatch(r -> r.unit().equals("°C"));
        assertThat(report.readings().stream().map(r -> r.boat()).distinct()).containsExactly("boat1", "boat2");
    }

    @Test
    void equalSettingsGiveEqualRunsAndEqualReadings() {
        RunReport one = run(ROUGH, 3);
        RunReport same = run(ROUGH, 3);

        assertThat(same.result().runHash()).isEqualTo(one.result().runHash());
        assertThat(same.readings()).isEqualTo(one.readings());
        assertThat(run(ROUGH, 4).readings()).isNotEqualTo(one.readings());
    }

    @Test
    void sensorsAloneChangeNothingAboutTheRun() {
        Conditions onlySensors = new Conditions(0, 0, Flow.NONE, Flow.NONE, ROUGH.sensors());

        assertThat(run(onlySensors, 3).result().runHash())
                .isEqualTo(run(Conditions.CALM, 3).result().runHash());
    }

    @Test
    void recorderKeepsWhatFitsAndSaysHowMuchIsMissing() {
        ReadingRecorder recorder = new ReadingRecorder(3);
        for (int i = 0; i < 5; i++) {
            recorder.onReading(new SensorValue(7, "boat1", "water", "ph", List.of(7.0 + i), "", GeoPoint.of(45, 10)));
        }

        assertThat(recorder.readings()).hasSize(3);
        assertThat(recorder.notes(9)).hasSize(1);
        assertThat(recorder.notes(9).get(0).message()).contains("2 readings").contains("3");
    }
}
