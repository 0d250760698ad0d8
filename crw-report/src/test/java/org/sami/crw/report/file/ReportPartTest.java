package org.sami.crw.report.file;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.report.OperatorAction;
import org.sami.crw.report.OperatorActionsPart;
import org.sami.crw.report.PhaseResult;
import org.sami.crw.report.PhasesPart;
import org.sami.crw.report.ReportPart;
import org.sami.crw.report.ReportText;
import org.sami.crw.report.RunReport;
import org.sami.crw.report.SampleReport;

/** Parts of a report that say by themselves how they are written. */
class ReportPartTest {
    @TempDir
    private Path folder;

    /** A figure that no writer knows. */
    private record Waiting(List<Row> boats) implements ReportPart {
        /** One of its rows. */
        record Row(String boat, int seconds) {}

        @Override
        public String name() {
            return "waiting";
        }

        @Override
        public List<?> json() {
            return boats;
        }

        @Override
        public List<String> lines() {
            return boats.stream()
                    .map(row -> "  " + row.boat + " waited " + row.seconds + " s, 100 %")
                    .toList();
        }

        @Override
        public List<String> columns() {
            return List.of("boat", "seconds");
        }

        @Override
        public List<List<Object>> rows() {
            return boats.stream()
                    .map(row -> List.<Object>of(row.boat, row.seconds))
                    .toList();
        }
    }

    private static RunReport with(ReportPart... parts) {
        RunReport sample = SampleReport.of(2, 3);
        return new RunReport(
                sample.header(),
                sample.result(),
                sample.boats(),
                sample.locations(),
                sample.decisions(),
                sample.firings(),
                sample.interrupts(),
                sample.notes(),
                sample.readings(),
                sample.tasks(),
                sample.waits(),
                sample.origin(),
                sample.map(),
                List.of(parts));
    }

    @Test
    void partThatNoWriterKnowsIsInJsonTextAndFiles() throws Exception {
        RunReport report = with(new Waiting(List.of(new Waiting.Row("anna", 12))));

        new ReportFolder(folder).write(report);

        JsonNode json = new ObjectMapper().readTree(ReportJson.text(report));
        assertThat(json.path("waiting").toString()).isEqualTo("[{\"boat\":\"anna\",\"seconds\":12}]");
        assertThat(ReportText.text(report)).contains("\n  anna waited 12 s, 100 %\n");
        assertThat(Files.readString(folder.resolve("waiting.csv"))).isEqualTo("boat,seconds\nanna,12\n");
    }

    @Test
    void phasesAndTheOperatorsActionsAreWrittenUnderTheirNames() throws Exception {
        JsonNode json = new ObjectMapper()
                .readTree(ReportJson.text(with(
                        new PhasesPart(List.of(new PhaseResult(1, "clv", "Visits", "boats", "go", "done", 2))),
                        new OperatorActionsPart(List.of(
                                action(Optional.of(45.5), Optional.of(10.25)),
                                action(Optional.empty(), Optional.empty()))))));

        assertThat(json.path("phases").toString())
                .isEqualTo(
                        "[{\"mission\":1,\"plan\":\"clv\",\"phase\":\"Visits\",\"actor\":\"boats\",\"action\":\"go\","
                                + "\"status\":\"done\",\"executions\":2}]");
        assertThat(json.path("operator").toString())
                .isEqualTo(
                        "[{\"number\":1,\"at\":1.5,\"kind\":\"note\",\"text\":\"weed\",\"mission\":0,\"boats\":[\"anna\"],"
                                + "\"latDeg\":45.5,\"lonDeg\":10.25},"
                                + "{\"number\":1,\"at\":1.5,\"kind\":\"note\",\"text\":\"weed\",\"mission\":0,\"boats\":[\"anna\"]}]");
    }

    private static OperatorAction action(Optional<Double> latDeg, Optional<Double> lonDeg) {
        return new OperatorAction(1, 1500, "note", "weed", 0, List.of("anna"), latDeg, lonDeg);
    }
}
