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
import java.util.Random;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.server.log.LogLines;
import org.sami.boat.server.tcp.TcpServerListener;
import org.sami.crw.sim.boat.BoatOnTcp;
import org.sami.crw.sim.boat.BoatSettings;
import org.sami.crw.sim.cli.CommandResult;
import org.sami.crw.sim.cli.CrwProcess;
import org.sami.spn.value.GeoPoint;

/** Real processes of {@code crw run --connect}, killed as by {@code kill -9}, and what the next process makes of their journals. */
@Tag("process")
@Timeout(600)
class KilledRunTest {
    private static final int KILLS = Integer.getInteger("crw.kills", 8);

    /** Each lane has its own boats and kills one run after another. */
    private static final int LANES = 4;

    /** The mission begins within the first second and takes some ten. */
    private static final double EARLIEST_S = 0.2;

    private static final double LATEST_S = 9;
    private static final int LOCATIONS = 4;

    @TempDir
    private Path folder;

    /** What became of one run. */
    private record Fate(boolean killed, long resumedFrom) {}

    @Test
    void killedAnywhereItIsTakenUpVisitsEverythingAndNoCommandIsExecutedTwice() throws Exception {
        Random random = new Random(59);
        ExecutorService lanes = Executors.newFixedThreadPool(LANES);
        try {
            List<Future<Fate>> fates = new ArrayList<>();
            for (int i = 0; i < KILLS; i++) {
                Path place = Files.createDirectory(folder.resolve("kill" + i));
                double afterS = EARLIEST_S + (LATEST_S - EARLIEST_S) * (i + random.nextDouble()) / KILLS;
                long seed = 100L + i;
                fates.add(lanes.submit(() -> killedAndTakenUp(place, seed, afterS)));
            }
            List<Fate> all = new ArrayList<>();
            for (Future<Fate> fate : fates) {
                all.add(fate.get(300, TimeUnit.SECONDS));
            }
            assertThat(all.stream().filter(Fate::killed).count())
                    .as("runs that were still alive")
                    .isGreaterThanOrEqualTo(KILLS * 3 / 4);
            assertThat(all.stream().map(Fate::resumedFrom).collect(Collectors.toSet()))
                    .as("different places of death")
                    .hasSizeGreaterThanOrEqualTo(KILLS / 4);
        } finally {
            lanes.shutdownNow();
        }
    }

    private static Fate killedAndTakenUp(Path place, long seed, double afterS) throws Exception {
        try (BoatOnTcp anna = boat("anna", place, 10.9);
                BoatOnTcp bert = boat("bert", place, 10.9001)) {
            Path journal = place.resolve("journal");
            boolean killed;
            try (CrwProcess run = CrwProcess.start(place, mission(journal, seed, List.of(anna, bert)))) {
                run.awaitErr("boats at ");
                killed = !isOver(run, afterS);
                run.kill();
            }

            CommandResult resumed = CommandResult.crw("resume", journal.toString(), "--json");

            String what = "killed after " + afterS + " s: " + resumed.err();
            assertThat(resumed.exitCode()).as(what).isZero();
            JsonNode report = new ObjectMapper().readTree(resumed.out());
            assertThat(report.path("outcome").asText()).as(what).isEqualTo("ended");
            assertThat(report.path("locationsVisited").asInt()).as(what).isEqualTo(LOCATIONS);
            for (String boat : List.of("anna", "bert")) {
                assertThat(executedIds(place, boat)).as(what).doesNotHaveDuplicates();
            }
            return new Fate(killed, report.path("resumedFrom").asLong());
        }
    }

    private static boolean isOver(CrwProcess run, double withinS) throws InterruptedException {
        return run.endsWithin((long) (withinS * 1000));
    }

    private static BoatOnTcp boat(String name, Path logs, double lonDeg) throws Exception {
        InetSocketAddress anyPort = new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);
        BoatSettings settings =
                BoatSettings.of(name, anyPort, GeoPoint.of(45.4, lonDeg), 1).loggingTo(logs);
        return new BoatOnTcp(settings, SteadyClock.ofThisMachine(), TcpServerListener.NONE);
    }

    private static List<String> mission(Path journal, long seed, List<BoatOnTcp> boats) {
        String addresses = boats.stream()
                .map(boat -> "127.0.0.1:" + boat.address().getPort())
                .collect(Collectors.joining(","));
        return List.of(
                "run",
                "clv",
                "--connect",
                addresses,
                "--area",
                "24",
                "--locations",
                "" + LOCATIONS,
                "--seed",
                "" + seed,
                "--answer-after",
                "0.2",
                "--for",
                "200",
                "--journal",
                journal.toString());
    }

    private static List<String> executedIds(Path place, String boat) throws Exception {
        List<String> ids = new ArrayList<>();
        LogLines.read(
                place.resolve(boat + ".log"), entry -> ids.add(entry.command().commandId()));
        return ids;
    }
}
