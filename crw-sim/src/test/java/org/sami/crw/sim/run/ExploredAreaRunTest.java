package org.sami.crw.sim.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.crw.report.Exploration;
import org.sami.crw.report.ReportText;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.RunReport;
import org.sami.crw.report.file.ReportJson;
import org.sami.crw.sim.hull.Conditions;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.crw.sim.run.settings.RunSettings;

/** What a report says of an area that was explored: by the plan, by reported positions, and truly. */
class ExploredAreaRunTest {
    private static final Pattern TOLD = Pattern.compile("Explored ([0-9.]+) % of .*; as positions err by [0-9.]+ m, "
            + "about (\\d+) % are likely missed between the lanes unseen");

    @Test
    void whatIsCoveredInCalmWaterIsWhatWasPlanned() {
        Exploration explored = explored(run(Conditions.CALM, 10));

        assertThat(explored.percent(explored.left().plannedM2().orElseThrow())).isGreaterThan(99.9);
        assertThat(explored.percent(explored.left().trueM2().orElseThrow())).isGreaterThan(99.5);
        assertThat(explored.left().reportedM2()).isEqualTo(explored.left().trueM2());
    }

    /** Boats keep to their lanes by positions that err, so that they report better tracks than they drive. */
    @Test
    void whereInstrumentsErrTrueTracksCoverLessThanReportedOnesAndTheReportSaysBoth() throws Exception {
        RunReport report = run(Conditions.FIELD, 10);

        Exploration explored = explored(report);
        double plannedM2 = explored.left().plannedM2().orElseThrow();
        double reportedM2 = explored.left().reportedM2().orElseThrow();
        double trueM2 = explored.left().trueM2().orElseThrow();
        assertThat(explored.percent(plannedM2)).isGreaterThan(99.9);
        assertThat(explored.percent(reportedM2)).isBetween(97.0, 99.95);
        assertThat(explored.percent(trueM2)).isBetween(85.0, explored.percent(reportedM2) - 2);
        assertThat(explored.uncoveredM2()).isEqualTo(trueM2);
        assertThat(ReportText.text(report))
                .containsPattern(
                        "explored +\\d+\\.\\d\\d % of \\d+ m², \\d+ m² left; by reported positions 9\\d\\.\\d\\d %; "
                                + "by the plan (100\\.00|99\\.9\\d) %");
        JsonNode json = new ObjectMapper()
                .readTree(ReportJson.text(report))
                .get("explorations")
                .get(0);
        assertThat(json.get("trueUncoveredM2")).isEqualTo(json.get("uncoveredM2"));
        assertThat(json.get("reportedUncoveredM2").asDouble()).isLessThan(trueM2);
        assertThat(json.get("plannedUncoveredM2").asDouble()).isLessThan(reportedM2);
    }

    /** What the operator hears is what the report says of reported positions, and what is likely missed is foreseen. */
    @ParameterizedTest
    @CsvSource({"field, 10", "rough, 20"})
    void operatorHearsWhatWasReportedAndWhatIsLikelyMissedUnseen(String name, double spacingM) {
        Conditions conditions = name.equals("field") ? Conditions.FIELD : Conditions.ROUGH;

        RunReport report = run(conditions, spacingM);

        Exploration explored = explored(report);
        double reported = explored.percent(explored.left().reportedM2().orElseThrow());
        double unseen = reported - explored.percent(explored.left().trueM2().orElseThrow());
        Matcher told = report.notes().stream()
                .map(note -> TOLD.matcher(note.message()))
                .filter(Matcher::matches)
                .findFirst()
                .orElseThrow();
        assertThat(Double.parseDouble(told.group(1))).isCloseTo(reported, within(0.5));
        assertThat(Double.parseDouble(told.group(2))).isCloseTo(unseen, within(4.0));
        assertThat(report.notes())
                .filteredOn(note -> note.message().startsWith("Exploring"))
                .allSatisfy(note -> assertThat(note.message()).contains("likely missed between the lanes unseen"));
    }

    private static Exploration explored(RunReport report) {
        assertThat(report.result().outcome()).as(report.result().reason()).isEqualTo(RunOutcome.ENDED);
        assertThat(report.map().explorations()).hasSize(1);
        return report.map().explorations().get(0);
    }

    private static RunReport run(Conditions conditions, double spacingM) {
        RunPlan plan = TestRuns.plan("explore-area");
        return TestRuns.run(
                plan,
                RunSettings.of(plan.plan().id(), plan.plan().name(), new FleetSettings(3, 1, 150, 1).on(conditions))
                        .limitMillis(7_200_000)
                        .parameters(Map.of("@spacing", String.valueOf(spacingM)))
                        .build());
    }
}
