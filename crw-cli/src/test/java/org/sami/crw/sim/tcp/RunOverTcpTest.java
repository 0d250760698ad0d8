package org.sami.crw.sim.tcp;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.link.StopMotors;
import org.sami.boat.server.log.LoggedCommand;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.crw.cli.CommandResult;
import org.sami.crw.cli.CrwProcess;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.link.ProxyConfig;
import org.sami.crw.proxy.status.LinkState;
import org.sami.crw.proxy.tcp.BaseListener;
import org.sami.crw.proxy.tcp.TcpBase;
import org.sami.crw.proxy.tcp.TcpBaseConfig;

/** Missions of {@code crw run --connect} on boats that are processes of their own. */
@Tag("process")
@Timeout(900)
class RunOverTcpTest {
    private static final ObjectMapper JSON = new ObjectMapper();

    @TempDir
    private Path folder;

    private List<String> mission(BoatProcesses fleet, String... more) {
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

    private static CommandResult crw(List<String> arguments) {
        return CommandResult.crw(arguments.toArray(String[]::new));
    }

    @Test
    @Execution(ExecutionMode.CONCURRENT)
    void missionOnThreeBoatsVisitsEverythingAndTheReportNamesEachLink() throws Exception {
        try (BoatProcesses fleet = new BoatProcesses(folder).with("anna", "bert", "cleo")) {
            Path report = folder.resolve("report");
            CommandResult ran = crw(mission(fleet, "--json", "--report", report.toString()));

            assertThat(ran.exitCode()).as(ran.err()).isZero();
            JsonNode json = JSON.readTree(ran.out());
            assertThat(json.path("outcome").asText()).isEqualTo("ended");
            assertThat(json.path("locationsVisited").asInt()).isEqualTo(5);
            assertThat(json.path("boats").findValuesAsText("id")).containsExactly("anna", "bert", "cleo");
            for (JsonNode boat : json.path("boats")) {
                String name = boat.path("id").asText();
                assertThat(boat.path("link").asText()).isEqualTo("tcp 127.0.0.1:" + fleet.port(name));
                assertThat(boat.path("bootId").asText()).isNotEmpty();
                assertLostOnlyAsTold(boat, ran.err());
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

    /** A machine on which a process stands still for some seconds loses a link, and then it is said. */
    private static void assertLostOnlyAsTold(JsonNode boat, String err) {
        assertThat(boat.path("linkLost").asInt() > 0)
                .isEqualTo(err.contains("The link to " + boat.path("id").asText() + " is lost"));
    }

    private BoatProcesses underWay(BoatProcesses fleet) {
        Await.until(
                "all are under way",
                () -> Stream.of("anna", "bert")
                        .allMatch(boat ->
                                fleet.log(boat).stream().anyMatch(entry -> entry.command() instanceof StartWaypoints)));
        return fleet;
    }

    @Test
    @Execution(ExecutionMode.CONCURRENT)
    void signalStopsTheBoatsAndTheRunCanBeTakenUp() throws Exception {
        Path journal = folder.resolve("journal");
        try (BoatProcesses fleet = new BoatProcesses(folder).with("anna", "bert");
                CrwProcess run = CrwProcess.start(
                        folder,
                        mission(
                                fleet,
                                "--journal",
                                journal.toString(),
                                "--report",
                                folder.resolve("report").toString()))) {
            underWay(fleet);
            run.terminate();

            assertThat(run.await(60)).isEqualTo(143); // as the system says it of SIGTERM
            assertThat(run.err()).contains("stopped; go on with: crw resume " + journal);
            assertThat(run.out())
                    .contains("outcome             running")
                    .containsPattern(
                            "boats when the run stopped\n  anna .*\n  bert "); // what each does, as far as it is
            assertThat(folder.resolve("report").resolve("map.png")).isNotEmptyFile();
            for (String boat : List.of("anna", "bert")) {
                Await.until(boat + " has heard it", () -> {
                    List<LoggedCommand> log = fleet.log(boat);
                    return log.get(log.size() - 1).command() instanceof StopMotors;
                });
            }

            CommandResult resumed = crw(List.of("resume", journal.toString(), "--json"));
            JsonNode json = JSON.readTree(resumed.out());
            assertThat(json.path("outcome").asText()).isEqualTo("ended");
            assertThat(json.path("locationsVisited").asInt()).isEqualTo(5);
            json.path("boats").forEach(boat -> assertLostOnlyAsTold(boat, resumed.err()));
        }
    }

    @Test
    @Execution(ExecutionMode.CONCURRENT)
    void whyABoatStandsStillIsSaidAtOnceAndInTheReport() throws Exception {
        try (BoatProcesses fleet = new BoatProcesses(folder).with("anna", "bert");
                CrwProcess run = CrwProcess.start(folder, mission(fleet));
                TcpBase other = new TcpBase(
                        TcpBaseConfig.of(ProxyConfig.DEFAULT.withClientId("other"), 1),
                        new SteadyClock(ProcessClock::ms),
                        new Watcher())) {
            underWay(fleet);
            other.connect(new InetSocketAddress(InetAddress.getLoopbackAddress(), fleet.port("anna")));
            Await.until("the other base watches anna", () -> isLinked(other));
            other.query(boats -> {
                        boats.find("anna").orElseThrow().handOver().takeCommand();
                        return true;
                    })
                    .join();

            run.awaitErr("Another base commands anna now; its commands wait");
            run.awaitErr(": another client commands the boat; one command waits"); // it may still go on along its list
            run.terminate();
            run.await(60);
            assertThat(run.out())
                    .containsPattern("\n  anna (does not move|moves at [0-9.]+ m/s): another client commands the boat;"
                            + " one command waits\n");
        }
    }

    private static boolean isLinked(TcpBase base) {
        return base.query(boats -> boats.find("anna")
                        .filter(boat -> boat.status().link() == LinkState.LINKED)
                        .isPresent())
                .join();
    }

    /** Only watches, until it takes the command. */
    private static final class Watcher implements BaseListener {
        @Override
        public Consumer<FleetEvent> found(String boatId) {
            return event -> {};
        }

        @Override
        public void onBoat(BoatProxy proxy) {
            proxy.handOver().observe();
        }
    }
}
