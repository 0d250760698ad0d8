package org.sami.crw.sim.tcp;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.server.tcp.TcpServerListener;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.sim.boat.BoatOnTcp;
import org.sami.crw.sim.boat.BoatSettings;
import org.sami.crw.sim.resume.ConnectedJournal;
import org.sami.crw.sim.resume.RunRecord;
import org.sami.crw.sim.run.RunObserver;
import org.sami.crw.sim.run.TestRuns;
import org.sami.crw.sim.run.record.RunProgress;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.crw.sim.run.settings.Speed;
import org.sami.spn.journal.JournalAddress;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.model.Project;
import org.sami.spn.value.GeoPoint;

/** A run over TCP whose plan connects to one boat more. */
@Timeout(900)
class BoatsOfPlansTest {
    private static final long WITHIN_MS = 60_000;
    private static final InetSocketAddress ANY_PORT = new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);

    @TempDir
    private Path folder;

    private final AtomicInteger connections = new AtomicInteger(); // to the plan's boat
    private volatile RunProgress progress = new RunProgress("", 0, 0, 0, 0, 0, 100);

    private BoatOnTcp boat(String name, TcpServerListener listener) throws IOException {
        BoatSettings settings =
                BoatSettings.of(name, ANY_PORT, GeoPoint.of(45.4, 10.9), 1).loggingTo(folder);
        return new BoatOnTcp(settings, new SteadyClock(ProcessClock::ms), listener);
    }

    private static BoatAddress address(BoatOnTcp boat) {
        return new BoatAddress("127.0.0.1", boat.address().getPort());
    }

    /** It connects to a boat's server, then asks whether all is well. */
    private static RunPlan plan(BoatAddress other) {
        Project project = new ProjectReader(TestRuns.LIBRARY.vocabulary())
                .read(TestRuns.text("connecting-project.json").replace("HOST:PORT", other.toString()))
                .orThrow();
        return new RunPlan(
                TestRuns.LIBRARY.vocabulary(), project, project.plan("p").orElseThrow());
    }

    private RunOutcome run(RunPlan plan, RunSettings settings, ConnectedJournal journal, BooleanSupplier stop)
            throws IOException {
        RunProcess process = new RunProcess(new SteadyClock(ProcessClock::ms), "base" + connections, WITHIN_MS);
        return new TcpRun(plan, settings, AnswersFile.EMPTY, journal, process, line -> {})
                .run(new RunObserver(now -> progress = now, stop))
                .result()
                .outcome();
    }

    @Test
    void runThatIsResumedReachesTheBoatsThatItsPlanHadConnected() throws Exception {
        TcpServerListener counting = new TcpServerListener() {
            @Override
            public void connected(String client) {
                connections.incrementAndGet();
            }
        };
        try (BoatOnTcp anna = boat("anna", TcpServerListener.NONE);
                BoatOnTcp bert = boat("bert", counting)) {
            RunPlan plan = plan(address(bert));
            RunSettings settings = settings(anna);
            RunRecord record = new RunRecord(
                    settings,
                    "p",
                    new ProjectWriter(plan.vocabulary()).text(plan.project()),
                    TestRuns.LIBRARY.files().texts());
            Path file = folder.resolve("journal");
            try (ConnectedJournal journal = ConnectedJournal.create(JournalAddress.of(file), record)) {
                assertThat(run(plan, settings, journal, () -> progress.openDecisions() > 0))
                        .isEqualTo(RunOutcome.RUNNING);
            }
            assertThat(connections).hasValue(1);

            try (ConnectedJournal journal = ConnectedJournal.open(JournalAddress.of(file))) {
                run(plan, settings, journal, () -> connections.get() > 1);
            }

            assertThat(connections).hasValue(2);
        }
    }

    private static RunSettings settings(BoatOnTcp boat) {
        return RunSettings.of("p", "p", new FleetSettings(1, 1, 20, 1))
                .speed(Speed.REAL)
                .limitMillis(WITHIN_MS)
                .answerAfterMillis(10 * WITHIN_MS)
                .connect(List.of(address(boat)))
                .build();
    }
}
