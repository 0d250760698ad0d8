package org.sami.crw.sim.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.crw.report.NoteResult;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.RunReport;
import org.sami.crw.report.VesselsPart;
import org.sami.crw.report.VesselsPart.VesselApproach;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.crw.sim.run.settings.SettingsMap;
import org.sami.crw.sim.vessel.ForeignVessels;

/** Runs among other vessels: what the operator learns of them, and what the report says. */
class VesselsRunTest {
    private static final String FERRY = """
            {"format": "crw-vessels", "sight": 50, "vessels": [
              {"name": "ferry", "length": 12, "beam": 4,
               "track": [{"at": 0, "east": -150, "north": 60}, {"at": 200, "east": 250, "north": 60}]},
              {"name": "log", "length": 3, "beam": 0.5, "drifts": true, "track": [{"east": 10, "north": 40}]},
              {"name": "tanker", "length": 40, "beam": 10, "track": [{"east": 3000, "north": 3000}]}]}""";

    private static RunSettings settings(ForeignVessels vessels) {
        return RunSettings.of("clv", "Visit", new FleetSettings(3, 6, 120, 1).among(vessels))
                .limitMillis(3_600_000)
                .build();
    }

    private static RunReport run(ForeignVessels vessels) {
        return TestRuns.run(TestRuns.plan("clv"), settings(vessels));
    }

    @Test
    void operatorLearnsOfAVesselWhenABoatSeesItAndBoatsGiveWay() {
        RunReport report = run(ForeignVessels.parse(FERRY));

        assertThat(report.result().outcome()).isEqualTo(RunOutcome.ENDED);
        List<VesselApproach> nearest =
                report.part(VesselsPart.class).orElseThrow().approaches();
        assertThat(nearest)
                .extracting(VesselApproach::vessel)
                .contains("ferry", "log")
                .doesNotContain("tanker");
        assertThat(nearest).allSatisfy(one -> assertThat(one.distanceM()).isGreaterThan(3));
        assertThat(report.notes())
                .extracting(NoteResult::message)
                .anyMatch(text -> text.matches("boat[123] sees vessel 1, 12 m long, 2.0 m/s to 090°, \\d+ m away"))
                .anyMatch(text -> text.matches("boat[123] sees vessel 2, 3 m long, at rest, \\d+ m away"))
                .noneMatch(text -> text.contains("vessel 3") || text.contains("tanker") || text.contains("ferry"));
    }

    @Test
    void equalVesselsGiveEqualRunsAndNoneGiveTheRunThatThereWas() {
        String hash = run(ForeignVessels.parse(FERRY)).result().runHash();

        assertThat(run(ForeignVessels.parse(FERRY)).result().runHash()).isEqualTo(hash);
        assertThat(run(ForeignVessels.NONE).result().runHash()).isNotEqualTo(hash);
    }

    @Test
    void vesselsAreKeptWithTheSettings() {
        RunSettings settings = settings(ForeignVessels.parse(FERRY));

        assertThat(SettingsMap.read(SettingsMap.write(settings))).isEqualTo(settings);
        assertThat(SettingsMap.write(settings(ForeignVessels.NONE))).doesNotContainKey("vessels");
    }

    @Test
    void fileThatMakesNoSenseIsRefusedWithThePlace() {
        assertThatThrownBy(() -> ForeignVessels.parse("{}")).hasMessageContaining("crw-vessels");
        assertThatThrownBy(() -> ForeignVessels.parse(FERRY.replace("\"beam\": 4", "\"beam\": 40")))
                .hasMessageContaining("ferry is 12.0 m long and 40.0 m wide");
        assertThatThrownBy(() -> ForeignVessels.parse(FERRY.replace("\"at\": 200", "\"at\": 2")))
                .hasMessageContaining("at most 20 m/s");
        assertThatThrownBy(() -> ForeignVessels.parse(FERRY.replace("\"length\": 3", "\"size\": 3")))
                .hasMessageContaining("/vessels/1: \"size\" is none of");
    }
}
