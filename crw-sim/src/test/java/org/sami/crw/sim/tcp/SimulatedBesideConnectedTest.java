package org.sami.crw.sim.tcp;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.List;
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
import org.sami.crw.report.RunReport;
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
import org.sami.crw.sim.run.settings.Site;
import org.sami.crw.sim.run.settings.Speed;
import org.sami.spn.journal.JournalAddress;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.value.GeoPoint;

/** A run over TCP with a simulated boat of its own process beside the connected one. */
@Timeout(900)
class SimulatedBesideConnectedTest {
    private static final GeoPoint CENTRE = GeoPoint.of(45.7, 10.72);
    private static final int LOCATIONS = 6;

    @TempDir
    private Path folder;

    private int processes;
    private volatile RunProgress progress = new RunProgress("", 0, 0, 0, 0, 0, 100);

    @Test
    void runThatIsResumedLaunchesItsSimulatedBoatAgainWhereItWas() throws Exception {
        InetSocketAddress anyPort = new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);
        try (BoatOnTcp anna = new BoatOnTcp(
                BoatSettings.of("anna", anyPort, CENTRE, 1),
                new SteadyClock(ProcessClock::ms),
                TcpServerListener.NONE)) {
            RunPlan plan = TestRuns.plan("clv");
            RunSettings settings = RunSettings.of(
                            "clv", "clv", new FleetSettings(2, LOCATIONS, 40, 1).at(Site.at(CENTRE)))
                    .speed(Speed.REAL)
                    .limitMillis(600_000)
                    .answerAfterMillis(200)
                    .connect(List.of(new BoatAddress("127.0.0.1", anna.address().getPort())))
                    .build();
            RunRecord record = new RunRecord(
                    settings,
                    "clv",
                    new ProjectWriter(plan.vocabulary()).text(plan.project()),
                    TestRuns.LIBRARY.files().texts());
            JournalAddress file = JournalAddress.of(folder.resolve("journal"));
            try (ConnectedJournal journal = ConnectedJournal.create(file, record)) {
                RunReport first = run(plan, settings, journal, () -> progress.visited() > 1);
                assertThat(first.result().outcome()).isEqualTo(RunOutcome.RUNNING);
            }

            try (ConnectedJournal journal = ConnectedJournal.open(file)) {
                RunReport second = run(plan, settings, journal, () -> false);

                assertThat(second.result().outcome()).isEqualTo(RunOutcome.ENDED);
                assertThat(progress.visited()).isEqualTo(LOCATIONS);
                assertThat(second.boats()).extracting("id").containsExactlyInAnyOrder("anna", "boat1");
            }
        }
    }

    private RunReport run(RunPlan plan, RunSettings settings, ConnectedJournal journal, BooleanSupplier stop)
            throws IOException {
        RunProcess process = new RunProcess(new SteadyClock(ProcessClock::ms), "base" + processes++, 60_000);
        return new TcpRun(plan, settings, AnswersFile.EMPTY, journal, process, line -> {})
                .run(new RunObserver(now -> progress = now, stop));
    }
}
