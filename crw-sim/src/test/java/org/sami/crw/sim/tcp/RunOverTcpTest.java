package org.sami.crw.sim.tcp;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.sim.cli.Ran;

/** Missions of {@code crw run --connect} on boats that are processes of their own. */
@Timeout(240)
class RunOverTcpTest {
    private static final ObjectMapper JSON = new ObjectMapper();

    @TempDir
    private Path folder;

    private List<String> mission(Fleet fleet, String... more) {
        List<String> arguments = new ArrayList<>(List.of(
                "run",
                "clv",
                "--connect",
                fleet.addresses(),
                "--area",
                "40",
                "--locations",
                "5",
                "--answer-after",
                "0.2",
                "--for",
                "120"));
        arguments.addAll(List.of(more));
        return arguments;
    }

    private static Ran crw(List<String> arguments) {
        return Ran.crw(arguments.toArray(String[]::new));
    }

    @Test
    void missionOnThreeBoatsVisitsEverythingAndTheReportNamesEachLink() throws Exception {
        try (Fleet fleet = new Fleet(folder).with("anna", "bert", "cleo")) {
            Path report = folder.resolve("report");
            Ran ran = crw(mission(fleet, "--json", "--report", report.toString()));

            assertThat(ran.exitCode()).as(ran.err()).isZero();
            JsonNode json = JSON.readTree(ran.out());
            assertThat(json.path("outcome").asText()).isEqualTo("ended");
            assertThat(json.path("locationsVisited").asInt()).isEqualTo(5);
            assertThat(json.path("boats").findValuesAsText("id")).containsExactly("anna", "bert", "cleo");
            for (JsonNode boat : json.path("boats")) {
                String name = boat.path("id").asText();
                assertThat(boat.path("link").asText()).isEqualTo("tcp 127.0.0.1:" + fleet.port(name));
                assertThat(boat.path("bootId").asText()).isNotEmpty();
                assertThat(boat.path("linkLost").asInt()).isZero();
                assertThat(boat.path("uploads").path("readBackEqual").asInt())
                        .isEqualTo(boat.path("uploads").path("sent").asInt());
                assertThat(fleet.commandIds(name)).doesNotHaveDuplicates();
            }
            assertThat(report.resolve("map.png")).isNotEmptyFile();
            assertThat(Files.readString(report.resolve("boats.csv")))
                    .contains("anna,tcp 127.0.0.1:" + fleet.port("anna") + ",");
            assertThat(Files.readString(report.resolve("tracks.csv"))).contains("anna,", "bert,", "cleo,");
        }
    }
}
