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
import java.util.OptionalLong;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;
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

/** Real processes of {@code crw run --connect}, killed as by {@code kill -9}, and what the next process makes of their journals. */
@Tag("process")
@Timeout(600)
class KilledRunTest {
    private static final int KILLS = Integer.getInteger("crw.kills", 8);

    /** Each lane has its own boats and kills one run after another. */
    private static final int LANES = 4;

    /** Entries and telemetry; a run writes some more. */
    private static final long ROWS = 110;

    private static final int LOCATIONS = 4;

    @TempDir
    private Path folder;

    @Test
    void killedAnywhereItIsTakenUpVisitsEverythingAndNoCommandIsExecutedTwice() throws Exception {
        Random random = new Random(59);
        ExecutorService lanes = Executors.newFixedThreadPool(LANES);
        try {
            List<Future<Long>> deaths = new ArrayList<>();
            for (int i = 0; i < KILLS; i++) {
                Path place = Files.createDirectory(folder.resolve("kill" + i));
                long row = 1 + (long) (ROWS * (i + random.nextDouble()) / KILLS);
                long seed = 100L + i;
                deaths.add(lanes.submit(() -> killedAndTakenUp(place, seed, row)));
            }
            Set<Long> resumedFrom = new TreeSet<>();
            for (Future<Long> death : deaths) {
                resumedFrom.add(death.get());
            }
            assertThat(resumedFrom).as("different places of death").hasSizeGreaterThanOrEqualTo(KILLS / 4);
        } finally {
            lanes.shutdownNow();
        }
    }

    /**
     * Kills a run once its journal has so many rows, and takes it up; where it was over before it could be killed, another one.
     *
     * @return after which entry it died
     */
    private static long killedAndTakenUp(Path place, long seed, long row) throws Exception {
        for (int i = 1; ; i++) {
            Path tried = Files.createDirectory(place.resolve("run" + i));
            OptionalLong died = killedAndTakenUpWhereItWasAlive(tried, seed, row);
            if (died.isPresent()) {
                return died.getAsLong();
            }
        }
    }

    private static OptionalLong killedAndTakenUpWhereItWasAlive(Path place, long seed, long row) throws Exception {
        try (BoatOnTcp anna = boat("anna", place, 10.9);
                BoatOnTcp bert = boat("bert", place, 10.9001)) {
            Path journal = place.resolve("journal");
            try (CrwProcess run = CrwProcess.start(place, mission(journal, seed, List.of(anna, bert)))) {
                run.awaitErr("boats at ");
                JournalEntries.killOnce(() -> JournalEntries.withTelemetryIn(journal) >= row, run);
            }

            CommandResult resumed = CommandResult.crw("resume", journal.toString(), "--json");

            String what = "killed at row " + row + ": " + resumed.err();
            assertThat(resumed.exitCode()).as(what).isZero();
            JsonNode report = new ObjectMapper().readTree(resumed.out());
            assertThat(report.path("outcome").asText()).as(what).isEqualTo("ended");
            assertThat(report.path("locationsVisited").asInt()).as(what).isEqualTo(LOCATIONS);
            for (String boat : List.of("anna", "bert")) {
                assertThat(executedIds(place, boat)).as(what).doesNotHaveDuplicates();
            }
            return resumed.err().contains("this run was over already")
                    ? OptionalLong.empty()
                    : OptionalLong.of(report.path("resumedFrom").asLong());
        }
    }

    private static BoatOnTcp boat(String name, Path logs, double lonDeg) throws Exception {
        InetSocketAddress anyPort = new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);
        BoatSettings settings =
                BoatSettings.of(name, anyPort, GeoPoint.of(45.4, lonDeg), 1).loggingTo(logs);
        return new BoatOnTcp(settings, new SteadyClock(ProcessClock::ms), TcpServerListener.NONE);
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
