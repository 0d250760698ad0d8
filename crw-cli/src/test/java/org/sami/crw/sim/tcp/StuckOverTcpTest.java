package org.sami.crw.sim.tcp;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.cli.CommandResult;
import org.sami.crw.sim.run.TestRuns;

/** A run over TCP in which nothing can happen any longer ends and says why. */
@Tag("process")
@Timeout(900)
class StuckOverTcpTest {
    @TempDir
    private Path folder;

    @Test
    void missionThatWantsNothingOfItsBoatsIsStuckAtOnceAndSaysWhatItWaitsFor() throws Exception {
        Path project = Files.writeString(folder.resolve("stuck.json"), TestRuns.text("stuck-project.json"));
        try (BoatProcesses fleet = new BoatProcesses(folder).with("anna")) {
            CommandResult ran = CommandResult.crw(
                    "run",
                    project.toString(),
                    "--plan",
                    "helped",
                    "--connect",
                    fleet.addresses(),
                    "--for",
                    "100",
                    "--json");

            JsonNode report = new ObjectMapper().readTree(ran.out());
            assertThat(ran.exitCode()).isEqualTo(4);
            assertThat(report.path("simulatedSeconds").asDouble())
                    .as("long before its end")
                    .isLessThan(90);
            assertThat(report.at("/waitsFor/0/place").asText()).isEqualTo("Help");
            assertThat(report.at("/waitsFor/0/transitions/0/name").asText()).isEqualTo("Good");
            assertThat(ran.err())
                    .contains("crw: failed: nothing can happen in the mission any longer")
                    .contains("'Good' cannot fire: It waits for Check Return 'good', which can come no longer");
        }
    }
}
