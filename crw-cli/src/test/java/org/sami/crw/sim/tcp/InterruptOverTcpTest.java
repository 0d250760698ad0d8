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
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.server.log.LogLines;
import org.sami.boat.server.tcp.TcpServerListener;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.crw.cli.CommandResult;
import org.sami.crw.cli.CrwProcess;
import org.sami.crw.cli.JournalEntries;
import org.sami.crw.sim.boat.BoatOnTcp;
import org.sami.crw.sim.boat.BoatSettings;
import org.sami.spn.value.GeoPoint;

/** Interrupts in missions on boats behind TCP, whose process may die before, in and after them. */
@Tag("process")
@Timeout(900)
class InterruptOverTcpTest {
    private static final int LOCATIONS = 5;

    /** Entries of the journal: both boats are under way, the button has been pressed, and the boat has come to where it is recharged. */
    private static final List<Long> DEATHS = List.of(19L, 23L, 27L);

    @TempDir
    private Path folder;

    @Test
    void criticalBoatIsPulledOutAndHasAFullBatteryWhenItComesBack() throws Exception {
        try (BoatOnTcp anna = boat("anna", folder, 10.9, 50);
                BoatOnTcp bert = boat("bert", folder, 10.90006, 14)) {
            CommandResult ran = CommandResult.crw(mission(List.of(anna, bert), "recharge@battery", "@swapTime=16s")
                    .toArray(String[]::new));

            assertThat(ran.exitCode()).as(ran.err()).isZero();
            JsonNode report = new ObjectMapper().readTree(ran.out());
            assertTaken(report, "bert", ran.err());
            assertThat(report.path("boats").findValuesAsText("recharges")).containsExactly("0", "1");
            assertThat(report.path("boats").get(1).path("batteryPercent").asDouble())
                    .isGreaterThan(90);
        }
    }

    @Test
    void runThatIsKilledBeforeInOrAfterAnInterruptIsTakenUpAndTheBoatComesBack() throws Exception {
        ExecutorService lanes = Executors.newFixedThreadPool(DEATHS.size());
        try {
            List<Future<?>> fates = new ArrayList<>();
            for (long entry : DEATHS) {
                Path place = Files.createDirectory(folder.resolve("killed" + entry));
                fates.add(lanes.submit(() -> {
                    killAndTakeUp(place, entry);
                    return null;
                }));
            }
            for (Future<?> fate : fates) {
                fate.get();
            }
        } finally {
            lanes.shutdownNow();
        }
    }

    private static void killAndTakeUp(Path place, long entry) throws Exception {
        try (BoatOnTcp anna = boat("anna", place, 10.9, 100);
                BoatOnTcp bert = boat("bert", place, 10.90006, 100)) {
            Path journal = place.resolve("journal");
            List<String> mission = new ArrayList<>(mission(List.of(anna, bert), "recharge:anna@3", "@swapTime=2s"));
            mission.addAll(List.of("--journal", journal.toString()));
            try (CrwProcess run = CrwProcess.start(place, mission)) {
                run.awaitErr("boats at ");
                JournalEntries.killAt(entry, journal, run);
            }

            CommandResult resumed = CommandResult.crw("resume", journal.toString(), "--json");

            String what = "killed at entry " + entry + ": " + resumed.err();
            assertThat(resumed.exitCode()).as(what).isZero();
            assertTaken(new ObjectMapper().readTree(resumed.out()), "anna", what);
            for (String boat : List.of("anna", "bert")) {
                List<String> ids = new ArrayList<>();
                LogLines.read(
                        place.resolve(boat + ".log"),
                        done -> ids.add(done.command().commandId()));
                assertThat(ids).as(what).doesNotHaveDuplicates();
            }
        }
    }

    private static void assertTaken(JsonNode report, String boat, String what) {
        assertThat(report.path("outcome").asText()).as(what).isEqualTo("ended");
        assertThat(report.path("locationsVisited").asInt()).as(what).isEqualTo(LOCATIONS);
        assertThat(report.path("interrupts")).as(what).hasSize(1);
        assertThat(report.path("interrupts").get(0).path("boat").asText())
                .as(what)
                .isEqualTo(boat);
        assertThat(report.path("interrupts").get(0).path("takenAt").isNumber())
                .as(what)
                .isTrue();
    }

    private static BoatOnTcp boat(String name, Path logs, double lonDeg, double batteryPercent) throws Exception {
        InetSocketAddress anyPort = new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);
        BoatSettings settings = BoatSettings.of(name, anyPort, GeoPoint.of(45.4, lonDeg), 1)
                .withBatteryPercent(batteryPercent)
                .loggingTo(logs);
        return new BoatOnTcp(settings, new SteadyClock(ProcessClock::ms), TcpServerListener.NONE);
    }

    private static List<String> mission(List<BoatOnTcp> boats, String interrupt, String variable) {
        String addresses = boats.stream()
                .map(boat -> "127.0.0.1:" + boat.address().getPort())
                .collect(Collectors.joining(","));
        return List.of(
                "run",
                "clv-interrupts",
                "--connect",
                addresses,
                "--area",
                "24",
                "--locations",
                "" + LOCATIONS,
                "--answer-after",
                "0.2",
                "--for",
                "200",
                "--set",
                variable,
                "--interrupt",
                interrupt,
                "--json");
    }
}
