package org.sami.crw.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What is in a journal, for other programs. */
@Tag("long")
class ExportCommandTest {
    @TempDir
    private Path folder;

    private String path(String name) {
        return folder.resolve(name).toString();
    }

    private List<String> lines(String file) throws IOException {
        return Files.readAllLines(folder.resolve("out").resolve(file));
    }

    @Test
    void journalOfASessionBecomesTablesAndAMap() throws Exception {
        Files.writeString(folder.resolve("script"), """
            add sim 45.4,10.9
            wait boats 1 within 120
            start clv
            wait decision
            answer all
            wait decision
            answer 45.4001,10.9001;45.40012,10.9001
            wait decision
            answer 1
            wait ended within 120
            quit
            """);
        CommandResult session = CommandResult.crw("session", "--journal", path("journal"), "--script", path("script"));
        assertThat(session.exitCode()).as(session.out()).isZero();

        CommandResult exported = CommandResult.crw("export", path("journal"), path("out"));

        assertThat(exported.exitCode()).as(exported.err()).isZero();
        assertThat(exported.out()).contains("1 boats", "3 decisions");
        assertThat(lines("tracks.csv")).hasSizeGreaterThan(2).anyMatch(row -> row.startsWith("sim,"));
        assertThat(lines("events.csv")).anyMatch(row -> row.contains("Locations created"));
        assertThat(lines("decisions.csv")).hasSize(4).anyMatch(row -> row.contains("45.400100/10.900100"));
        assertThat(lines("messages.csv")).anyMatch(row -> row.contains("Sequential single-item auction"));
        assertThat(lines("operator.csv")).anyMatch(row -> row.contains("started clv as mission 1"));
        JsonNode map =
                new ObjectMapper().readTree(folder.resolve("out/map.geojson").toFile());
        assertThat(map.path("features"))
                .extracting(feature -> feature.path("properties").path("kind").asText())
                .contains("track", "path", "location");
    }

    @Test
    void filesThatAreThereAreReplacedOnlyWhenAsked() throws Exception {
        Files.writeString(folder.resolve("script"), "quit\n");
        CommandResult.crw("session", "--journal", path("journal"), "--script", path("script"));
        CommandResult.crw("export", path("journal"), path("out"));

        CommandResult refused = CommandResult.crw("export", path("journal"), path("out"));
        CommandResult replaced = CommandResult.crw("export", path("journal"), path("out"), "--overwrite");

        assertThat(refused.exitCode()).isEqualTo(2);
        assertThat(refused.err()).contains("tracks.csv is there already", "--overwrite");
        assertThat(replaced.exitCode()).as(replaced.err()).isZero();
    }

    @Test
    void runInProcessIsToldByRunningItAgain() {
        CommandResult.crw("run", "clv", "--speed", "max", "--for", "5", "--journal", path("journal"));

        CommandResult refused = CommandResult.crw("export", path("journal"), path("out"));

        assertThat(refused.exitCode()).isEqualTo(2);
        assertThat(refused.err()).contains("crw resume " + path("journal") + " --report " + path("out"));
    }
}
