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
import java.util.stream.StreamSupport;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.crw.cli.CrwProcess;
import org.sami.crw.decision.DomainQuestion;
import org.sami.crw.sim.boat.TestRelay;

/** Boats of a running mission that are killed as by {@code kill -9} and started again, with and without what they knew. */
@Tag("process")
@Timeout(900)
class KilledBoatTest {
    private static final long END_S = 280;

    @TempDir
    private Path folder;

    private CrwProcess run(String addresses, String... more) throws Exception {
        List<String> command = new ArrayList<>(List.of(
                "run",
                "clv",
                "--connect",
                addresses,
                "--area",
                "40",
                "--locations",
                "4",
                "--answer-after",
                "2",
                "--for",
                "270",
                "--json",
                "--report",
                folder.resolve("report").toString()));
        command.addAll(List.of(more));
        return CrwProcess.start(folder, command);
    }

    private Path state(boolean kept) {
        return kept ? folder : folder.resolve("empty");
    }

    @ParameterizedTest
    @Execution(ExecutionMode.CONCURRENT)
    @ValueSource(booleans = {true, false})
    void killedInMidPathItWaitsForTheOperatorAndTheMissionEnds(boolean withItsState) throws Exception {
        try (BoatProcesses fleet = new BoatProcesses(folder).with("anna", "bert");
                CrwProcess run = run(fleet.addresses())) {
            killBertInMidPath(fleet, run, state(withItsState));
        }
    }

    @Test
    @Execution(ExecutionMode.CONCURRENT)
    void killedInMidPathAPairedBoatIsKnownByItsKeyAgainAndTheMissionEnds() throws Exception {
        Path keys = folder.resolve("base-keys");
        try (BoatProcesses fleet = BoatProcesses.paired(folder, keys).with("anna", "bert");
                CrwProcess run = run(fleet.addresses(), "--keys", keys.toString())) {
            killBertInMidPath(fleet, run, folder);
        }
    }

    private void killBertInMidPath(BoatProcesses fleet, CrwProcess run, Path state) throws Exception {
        Await.until("bert is under way", () -> executed(fleet, "bert", StartWaypoints.class) > 0);
        run.awaitErr("visited 1/4");
        fleet.kill("bert");
        run.awaitErr("The link to bert is lost; its commands wait");
        fleet.startAgain("bert", state);
        run.awaitErr("bert has started anew; it does not move until it is allowed to");

        assertThat(run.await(END_S)).as(run.err()).isZero();
        assertEndedAfterTheOperatorWasAsked(fleet, run);
    }

    @ParameterizedTest
    @Execution(ExecutionMode.CONCURRENT)
    @ValueSource(booleans = {true, false})
    void killedInMidUploadItWaitsForTheOperatorAndTheMissionEnds(boolean withItsState) throws Exception {
        try (BoatProcesses fleet = new BoatProcesses(folder).with("anna", "bert");
                TestRelay relay = relayTo(fleet, "bert")) {
            relay.arm(new TestRelay.Cut(UploadWaypoints.class, TestRelay.Where.MIDDLE));
            try (CrwProcess run = run("127.0.0.1:" + fleet.port("anna") + ",127.0.0.1:"
                    + relay.address().getPort())) {
                Await.until("half an upload has gone", () -> !relay.isArmed());
                fleet.kill("bert");
                assertThat(executed(fleet, "bert", UploadWaypoints.class)).isZero();
                run.awaitErr("The link to bert is lost; its commands wait");
                fleet.startAgain("bert", state(withItsState));
                run.awaitErr("bert has started anew; it does not move until it is allowed to");

                assertThat(run.await(END_S)).as(run.err()).isZero();
                assertEndedAfterTheOperatorWasAsked(fleet, run);
            }
        }
    }

    private static TestRelay relayTo(BoatProcesses fleet, String boat) throws Exception {
        return new TestRelay(new InetSocketAddress(InetAddress.getLoopbackAddress(), fleet.port(boat)));
    }

    private static long executed(BoatProcesses fleet, String boat, Class<?> kind) {
        return fleet.log(boat).stream()
                .filter(entry -> kind.isInstance(entry.command()))
                .count();
    }

    private void assertEndedAfterTheOperatorWasAsked(BoatProcesses fleet, CrwProcess run) throws Exception {
        JsonNode report = new ObjectMapper().readTree(run.out());
        assertThat(report.path("outcome").asText()).isEqualTo("ended");
        assertThat(report.path("locationsVisited").asInt()).isEqualTo(4);
        JsonNode bert = report.path("boats").get(1);
        assertThat(bert.path("linkLost").asInt()).isPositive();
        assertThat(bert.path("linkBack").asInt())
                .isEqualTo(bert.path("linkLost").asInt());
        JsonNode question = StreamSupport.stream(report.path("decisions").spliterator(), false)
                .filter(decision -> decision.path("type").asText().equals(DomainQuestion.BOAT_RESTARTED.kind()))
                .findFirst()
                .orElseThrow();
        assertThat(question.path("by").asText()).isEqualTo("operator");
        assertRested(
                fleet,
                question.path("openedAt").asDouble(),
                question.path("closedAt").asDouble());
        assertThat(fleet.commandIds("anna")).doesNotHaveDuplicates();
        assertThat(fleet.commandIds("bert")).doesNotHaveDuplicates();
    }

    /** From when the operator was asked until the answer the boat lay at its quay. */
    private void assertRested(BoatProcesses fleet, double fromS, double toS) throws Exception {
        assertThat(toS).isGreaterThan(fromS + 1.5);
        LocalFrame quay = new LocalFrame(BoatProcesses.latDeg(), fleet.lonDeg("bert"));
        List<String> lines = Files.readAllLines(folder.resolve("report").resolve("tracks.csv"));
        lines.stream().skip(1).map(line -> line.split(",")).forEach(row -> {
            double atS = Double.parseDouble(row[1]);
            if (row[0].equals("bert") && atS > fromS + 0.5 && atS < toS) {
                double eastM = quay.eastM(Double.parseDouble(row[2]), Double.parseDouble(row[3]));
                double northM = quay.northM(Double.parseDouble(row[2]), Double.parseDouble(row[3]));
                assertThat(Math.hypot(eastM, northM)).as("at %s s", row[1]).isLessThan(0.5);
            }
        });
    }
}
