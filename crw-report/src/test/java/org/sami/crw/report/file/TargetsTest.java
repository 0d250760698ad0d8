package org.sami.crw.report.file;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.crw.report.ReadingResult;
import org.sami.crw.report.ReportText;
import org.sami.crw.report.RunReport;
import org.sami.crw.report.SampleReport;

/** Targets that copters saw, in a report. */
class TargetsTest {
    private static final RunReport REPORT = SampleReport.of(2, 1)
            .withReadings(List.of(
                    target(1500, "boat2", 9621, 45.70125, 10.7205),
                    target(2500, "boat1", 17, 45.702, 10.72),
                    target(3500, "boat1", 9621, 45.70125, 10.7205),
                    new ReadingResult(4000, "boat1", "air", "wind", List.of(3.0), "m/s", 45, 10)));

    private static ReadingResult target(long atMillis, String boat, double number, double latDeg, double lonDeg) {
        return new ReadingResult(atMillis, boat, "camera", "target", List.of(number, latDeg, lonDeg), "", 45.7, 10.72);
    }

    @Test
    void targetsAreListedWithTheirPlacesAndNotAveraged() {
        assertThat(ReportText.text(REPORT))
                .doesNotContain("camera target")
                .containsPattern("air wind +1 +3.00")
                .containsPattern("targets +reported +first at +place +by")
                .containsPattern("17 +1 +2.5 s +45.7020000,10.7200000 +boat1")
                .containsPattern("9621 +2 +1.5 s +45.7012500,10.7205000 +boat2, boat1");
    }

    @Test
    void targetsAreMembersOfTheirOwnInTheJson() throws Exception {
        JsonNode json = new ObjectMapper().readTree(ReportJson.text(REPORT));

        assertThat(json.get("readings")).hasSize(1);
        assertThat(json.path("targets")).hasSize(2);
        assertThat(json.path("targets").path(1))
                .hasToString("{\"number\":9621,\"latDeg\":45.70125,\"lonDeg\":10.7205,\"count\":2,\"firstAt\":1.5,"
                        + "\"boats\":[\"boat2\",\"boat1\"]}");
        assertThat(new ObjectMapper()
                        .readTree(ReportJson.text(SampleReport.of(1, 1)))
                        .has("targets"))
                .isFalse();
    }

    @Test
    void channelOfThatNameWithOtherValuesIsMeasured() {
        RunReport report = SampleReport.of(1, 1)
                .withReadings(List.of(new ReadingResult(1500, "boat1", "winch", "target", List.of(4.0), "m", 45, 10)));

        assertThat(ReportText.text(report)).containsPattern("winch target +1 +4.00");
    }
}
