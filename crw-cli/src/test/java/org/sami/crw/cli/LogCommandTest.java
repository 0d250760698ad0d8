package org.sami.crw.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class LogCommandTest {
    @TempDir
    Path folder;

    @Test
    void tellsWhatALogHolds() throws Exception {
        CommandResult ran = CommandResult.crw("log", log().toString());

        assertThat(ran.exitCode()).isZero();
        assertThat(ran.out())
                .contains("3, 2 of them entries, 1 unread")
                .contains("1 over 0 m in 1 stretch")
                .contains("unknown-topic: line 2");
        assertThat(ran.err()).isEmpty();
    }

    @Test
    void writesAReportAndPrintsJson() throws Exception {
        Path out = folder.resolve("out");

        CommandResult ran = CommandResult.crw("log", log().toString(), "--report", out.toString(), "--json");

        assertThat(ran.exitCode()).isZero();
        JsonNode json = new ObjectMapper().readTree(ran.out());
        assertThat(json.get("unreadLines").asInt()).isEqualTo(1);
        assertThat(json.at("/problems/0/lines/0").asInt()).isEqualTo(2);
        assertThat(ran.err()).contains("picture " + out.resolve("map.png"));
        assertThat(out.resolve("map.png")).exists();
    }

    @Test
    void whatIsNoLogHasItsOwnExitCode() throws Exception {
        Path empty = Files.createFile(folder.resolve("empty.txt"));

        CommandResult ran = CommandResult.crw("log", empty.toString());

        assertThat(ran.exitCode()).isEqualTo(1);
        assertThat(ran.err()).isEqualTo("crw: " + empty + " is empty" + System.lineSeparator());
        assertThat(CommandResult.crw("log", folder.resolve("none.txt").toString())
                        .exitCode())
                .isEqualTo(2);
    }

    private Path log() throws Exception {
        return Files.writeString(folder.resolve("boat.txt"), """
                100 01:02:03,4 POSE: {500000.0, 4482700.0, 172.35, Q[0.0,0.0,0.5]} @ 17North
                200 01:02:03,5 SONAR: 5
                300 01:02:03,6 COMPASS: 0.5
                """);
    }
}
