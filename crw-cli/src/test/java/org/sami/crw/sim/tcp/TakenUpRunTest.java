package org.sami.crw.sim.tcp;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.server.testing.Await;
import org.sami.crw.cli.CommandResult;
import org.sami.crw.cli.CrwProcess;

/** Runs over TCP that are taken up when not everything is as it was. */
@Tag("process")
@Timeout(900)
class TakenUpRunTest {
    private static final ObjectMapper JSON = new ObjectMapper();

    /** What is told of the process that tells it. */
    private static final Set<String> OF_THE_PROCESS = Set.of("version", "wallSeconds", "resumedFrom");

    @TempDir
    private Path folder;

    @Test
    @Execution(ExecutionMode.CONCURRENT)
    void runGoesOnWithoutABoatThatComesLaterAndIsToldAgainAsItWas() throws Exception {
        String journal = folder.resolve("journal").toString();
        try (BoatProcesses fleet = new BoatProcesses(folder).with("anna", "bert")) {
            killRunUnderWay(fleet, journal);
            fleet.kill("bert");
            String first;
            try (CrwProcess resumed =
                    CrwProcess.start(folder, List.of("resume", journal, "--json", "--connect-within", "10"))) {
                resumed.awaitErr("127.0.0.1:" + fleet.port("bert"));
                resumed.awaitErr("the mission goes on without it until it is there");
                resumed.awaitErr("bert does not move: the boat has not answered yet; one command waits");
                fleet.startAgain("bert", folder);
                resumed.awaitErr("bert has started anew; it does not move until it is allowed to");

                assertThat(resumed.await(120)).as(resumed.err()).isZero();
                first = resumed.out();
            }
            JsonNode report = JSON.readTree(first);
            assertThat(report.path("outcome").asText()).isEqualTo("ended");
            assertThat(report.path("locationsVisited").asInt()).isEqualTo(4);
            assertThat(fleet.commandIds("bert")).doesNotHaveDuplicates();

            CommandResult again = CommandResult.crw("resume", journal, "--json");

            JsonNode told = JSON.readTree(again.out());
            assertThat(again.exitCode()).isZero();
            assertThat(again.err()).contains("this run was over already");
            assertThat(report.path("readings").path(0).path("count").asInt()).isPositive();
            report.fieldNames().forEachRemaining(member -> {
                if (!OF_THE_PROCESS.contains(member)) {
                    assertThat(told.path(member)).as(member).isEqualTo(report.path(member));
                }
            });
        }
    }

    private void killRunUnderWay(BoatProcesses fleet, String journal) throws Exception {
        try (CrwProcess run = CrwProcess.start(
                folder,
                List.of(
                        "run",
                        "clv",
                        "--connect",
                        fleet.addresses(),
                        "--area",
                        "24",
                        "--locations",
                        "4",
                        "--answer-after",
                        "0.5",
                        "--journal",
                        journal))) {
            Await.until(
                    "bert is under way",
                    () -> fleet.log("bert").stream().anyMatch(entry -> entry.command() instanceof StartWaypoints));
            run.kill();
        }
    }

    @Test
    @Execution(ExecutionMode.CONCURRENT)
    void runThatNeverBeganIsTakenUpOnceItsBoatsAreThere() throws Exception {
        String journal = folder.resolve("journal").toString();
        try (BoatProcesses fleet = new BoatProcesses(folder).with("anna")) {
            fleet.kill("anna");
            CommandResult refused = CommandResult.crw(
                    "run",
                    "clv",
                    "--connect",
                    fleet.addresses(),
                    "--connect-within",
                    "0.5",
                    "--area",
                    "24",
                    "--locations",
                    "1",
                    "--answer-after",
                    "0.2",
                    "--journal",
                    journal);
            assertThat(refused.exitCode()).isEqualTo(4);
            assertThat(refused.err()).contains("does not answer", "once they are: crw resume " + journal);
            fleet.startAgain("anna", folder);

            CommandResult resumed = CommandResult.crw("resume", journal, "--json");

            assertThat(resumed.exitCode()).as(resumed.err()).isZero();
            assertThat(JSON.readTree(resumed.out()).path("locationsVisited").asInt())
                    .isEqualTo(1);
        }
    }
}
