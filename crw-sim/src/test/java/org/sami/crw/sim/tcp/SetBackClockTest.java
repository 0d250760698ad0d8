package org.sami.crw.sim.tcp;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.server.tcp.TcpServerListener;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.RunReport;
import org.sami.crw.sim.boat.BoatOnTcp;
import org.sami.crw.sim.boat.BoatSettings;
import org.sami.crw.sim.resume.ConnectedJournal;
import org.sami.crw.sim.run.RunObserver;
import org.sami.crw.sim.run.TestRuns;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.crw.sim.run.settings.Speed;
import org.sami.spn.value.GeoPoint;

/** The clock under a run and its boat is set back by an hour while the mission's timer runs. */
@Tag("long")
@Timeout(900)
class SetBackClockTest {
    private static final long HOUR_MS = 3_600_000;
    private static final long WATCH_MS = 5000;
    private static final long ANSWER_MS = 1000;
    /** What a busy machine may be late with what is due; far from an hour. */
    private static final long LATE_MS = 20_000;

    @TempDir
    private Path folder;

    private final AtomicLong setBackMs = new AtomicLong();

    /** A clock that can be set. */
    private SteadyClock clock() {
        return new SteadyClock(() -> ProcessClock.ms() - setBackMs.get());
    }

    @ParameterizedTest
    @Execution(ExecutionMode.CONCURRENT)
    @ValueSource(longs = {0, HOUR_MS})
    void nothingFiresEarlyOrLate(long byMs) throws Exception {
        RunPlan plan = TestRuns.plan("station-keep");
        InetSocketAddress anyPort = new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);
        BoatSettings settings =
                BoatSettings.of("anna", anyPort, GeoPoint.of(45.4, 10.9), 1).loggingTo(folder);
        try (BoatOnTcp boat = new BoatOnTcp(settings, clock(), TcpServerListener.NONE)) {
            long startMs = ProcessClock.ms();
            RunReport report = new TcpRun(
                            plan,
                            settings(boat),
                            AnswersFile.EMPTY,
                            ConnectedJournal.none(),
                            new RunProcess(clock(), "base", 20_000),
                            line -> {})
                    .run(new RunObserver(
                            progress -> {
                                if (progress.firings() >= 2) { // the timer runs
                                    setBackMs.set(byMs);
                                }
                            },
                            () -> false));
            long tookMs = ProcessClock.ms() - startMs;

            assertThat(setBackMs).hasValue(byMs);
            assertThat(report.result().outcome()).isEqualTo(RunOutcome.ENDED);
            assertThat(atMs(report, "Watch over") - atMs(report, "Stations found"))
                    .isBetween(WATCH_MS, WATCH_MS + LATE_MS);
            assertThat(atMs(report, "End confirmed") - atMs(report, "Watch over"))
                    .isBetween(ANSWER_MS, ANSWER_MS + LATE_MS);
            assertThat(report.result().simulatedMillis()).isBetween(WATCH_MS, tookMs + 500);
            assertThat(report.boats())
                    .singleElement()
                    .satisfies(anna -> assertThat(anna.link().lost()).isZero());
        }
    }

    private static RunSettings settings(BoatOnTcp boat) {
        return RunSettings.of("station-keep", "station-keep", new FleetSettings(1, 1, 20, 1))
                .speed(Speed.REAL)
                .limitMillis(60_000)
                .parameters(Map.of("watch-time.duration", WATCH_MS / 1000 + "s"))
                .answerAfterMillis(ANSWER_MS)
                .connect(List.of(new BoatAddress("127.0.0.1", boat.address().getPort())))
                .build();
    }

    private static long atMs(RunReport report, String transition) {
        return report.firings().stream()
                .filter(firing -> firing.transition().equals(transition))
                .findFirst()
                .orElseThrow()
                .atMillis();
    }
}
