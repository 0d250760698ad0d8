package org.sami.crw.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.time.ZoneId;
import java.time.temporal.ChronoUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.Version;

/** Where, when and by what a report came about. */
class OriginTest {
    private static final ObjectMapper JSON = new ObjectMapper();

    @TempDir
    Path folder;

    @Test
    void aReportSaysWhereWhenAndByWhatItCameAbout() throws Exception {
        Instant before = Instant.now().truncatedTo(ChronoUnit.MILLIS);
        CommandResult ran =
                CommandResult.crw("run", "clv", "--speed", "max", "--at", "45.4,10.9", "--for", "20", "--json");

        JsonNode json = JSON.readTree(ran.out());
        assertThat(Instant.parse(json.get("startedAt").asText())).isBetween(before, Instant.now());
        assertThat(json.get("timeZone").asText())
                .isEqualTo(ZoneId.systemDefault().getId());
        assertThat(json.get("version").asText()).isEqualTo(Version.ofThisProgram());
        assertThat(json.get("planHash").asText()).matches("[0-9a-f]{64}");
        assertThat(json.get("centre").toString()).isEqualTo("{\"latDeg\":45.4,\"lonDeg\":10.9}");
        assertThat(json.get("quay").get("latDeg").asDouble()).isBetween(45.397, 45.3972);
        assertThat(ran.err()).contains("centre 45.4000000,10.9000000, quay 45.397");
    }

    @Test
    void theTimeOfDayIsNotInTheHashOfARun() throws Exception {
        String[] command = {"run", "clv", "--speed", "max", "--for", "60", "--json"};
        JsonNode first = JSON.readTree(CommandResult.crw(command).out());
        JsonNode second = JSON.readTree(CommandResult.crw(command).out());

        assertThat(second.get("startedAt")).isNotEqualTo(first.get("startedAt"));
        assertThat(second.get("runHash")).isEqualTo(first.get("runHash"));
        assertThat(second.get("planHash")).isEqualTo(first.get("planHash"));
    }

    @Test
    void aRunThatIsTakenUpBeganWhenItBegan() throws Exception {
        String journal = folder.resolve("visit.journal").toString();
        JsonNode begun = JSON.readTree(CommandResult.crw(
                        "run",
                        "clv",
                        "--speed",
                        "max",
                        "--at",
                        "45.4,10.9",
                        "--for",
                        "60",
                        "--journal",
                        journal,
                        "--json")
                .out());
        JsonNode goneOn = JSON.readTree(
                CommandResult.crw("resume", journal, "--speed", "max", "--json").out());

        assertThat(goneOn.get("outcome").asText()).isEqualTo("ended");
        for (String same : new String[] {"startedAt", "timeZone", "planHash", "centre", "quay"}) {
            assertThat(goneOn.get(same)).as(same).isEqualTo(begun.get(same));
        }
    }

    @Test
    void aPlanElsewhereIsNotRunWithoutBeingSentThere() throws Exception {
        String text;
        try (var in = OriginTest.class.getResourceAsStream("/org/sami/crw/sim/allocation-at-once.json")) {
            text = new String(in.readAllBytes(), java.nio.charset.StandardCharsets.UTF_8);
        }
        Path plan = Files.writeString(
                folder.resolve("swapped.json"),
                text.replace("{\"lat\": 45.7, \"lon\": 10.72}", "{\"lat\": 10.72, \"lon\": 45.7}"));

        CommandResult ran = CommandResult.crw("run", plan.toString(), "--speed", "max", "--for", "20");
        CommandResult there =
                CommandResult.crw("run", plan.toString(), "--speed", "max", "--for", "20", "--at", "10.72,45.7");

        assertThat(ran.exitCode()).isEqualTo(ExitCode.USAGE);
        assertThat(ran.err())
                .contains("10.7200000,45.7000000", "5103 km", "45.7000000,10.7200000", "--at 10.7200000,45.7000000");
        assertThat(there.exitCode()).as(there.err()).isZero();
    }
}
