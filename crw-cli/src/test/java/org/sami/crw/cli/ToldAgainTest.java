package org.sami.crw.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.nio.file.Path;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The journal of a finished run is told again as the run was. */
class ToldAgainTest {
    private static final ObjectMapper JSON = new ObjectMapper();

    /** What is told of the process that tells it. */
    private static final Set<String> OF_THE_PROCESS = Set.of("wallSeconds", "resumedFrom");

    @TempDir
    Path folder;

    @Test
    void finishedRunToldAgainTellsTheSameOfAllItsBoats() throws Exception {
        String journal = folder.resolve("journal").toString();
        CommandResult run = CommandResult.crw(
                "run",
                "clv-interrupts",
                "--locations",
                "6",
                "--sensor",
                "temperature@0.1",
                "--gps-noise",
                "1",
                "--interrupt",
                "recharge:2@60",
                "--speed",
                "max",
                "--json",
                "--journal",
                journal);

        CommandResult again = CommandResult.crw("resume", journal, "--speed", "max", "--json");

        assertThat(again.exitCode()).isEqualTo(run.exitCode()).isZero();
        assertThat(again.err()).contains("this run was over already");
        JsonNode report = JSON.readTree(run.out());
        JsonNode told = JSON.readTree(again.out());
        report.fieldNames().forEachRemaining(member -> {
            if (!OF_THE_PROCESS.contains(member)) {
                assertThat(told.path(member)).as(member).isEqualTo(report.path(member));
            }
        });
    }
}
