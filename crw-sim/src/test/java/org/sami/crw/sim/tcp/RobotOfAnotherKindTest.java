package org.sami.crw.sim.tcp;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.server.tcp.TcpServerListener;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.session.Session;
import org.sami.crw.session.SessionListener;
import org.sami.crw.session.SessionRuntime;
import org.sami.crw.session.SessionSetup;
import org.sami.crw.sim.boat.BoatOnTcp;
import org.sami.crw.sim.boat.BoatSettings;
import org.sami.crw.sim.resume.ConnectedJournal;
import org.sami.crw.sim.run.RunObserver;
import org.sami.crw.sim.run.TestRuns;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.crw.sim.run.settings.Speed;
import org.sami.session.record.SessionNote;
import org.sami.spn.model.Project;
import org.sami.spn.value.GeoPoint;

/** A copter that is linked to a session of boats, and to a run of a plan of boats. */
@Timeout(300)
class RobotOfAnotherKindTest {
    private static final InetSocketAddress ANY_PORT = new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);
    private static final String WHY = "kite is a copter, and this session drives boats";

    private static BoatOnTcp copter() throws IOException {
        return kite(RobotKind.COPTER, ANY_PORT);
    }

    private static BoatOnTcp kite(RobotKind kind, InetSocketAddress at) throws IOException {
        return new BoatOnTcp(
                BoatSettings.of("kite", at, GeoPoint.of(45.4, 10.9), 1).of(kind),
                new SteadyClock(ProcessClock::ms),
                TcpServerListener.NONE);
    }

    private static BoatAddress address(BoatOnTcp robot) {
        return new BoatAddress("127.0.0.1", robot.address().getPort());
    }

    @Test
    void sessionSaysItInAMessageAndInTheListOfItsFleet() throws Exception {
        Project project = TestRuns.LIBRARY.projectOf("clv").orElseThrow();
        CompletableFuture<String> message = new CompletableFuture<>();
        SessionRuntime runtime = SessionRuntime.RealTime.named("base", new SteadyClock(ProcessClock::ms));
        try (BoatOnTcp kite = copter();
                Session session = Session.open(
                        SessionSetup.of(TestRuns.LIBRARY.vocabulary(), project).with(runtime))) {
            session.addListener(new SessionListener() {
                @Override
                public void onNote(SessionNote note) {
                    if (note.text().contains("is a copter")) {
                        message.complete(note.text());
                    }
                }
            });
            session.begin();
            session.fleet().connect(address(kite));

            assertThat(message.get(60, TimeUnit.SECONDS)).contains(WHY + ": no mission can command it");
            Await.until(
                    "the list says it",
                    () -> session.fleet()
                            .ask(boats ->
                                    boats.find("kite").orElseThrow().explain().text())
                            .toCompletableFuture()
                            .join()
                            .equals(WHY));
        }
    }

    @Test
    void sessionSaysItAlsoOfOneThatComesLaterWithTheNameOfOneThatItCommands() throws Exception {
        Project project = TestRuns.LIBRARY.projectOf("clv").orElseThrow();
        List<String> messages = new CopyOnWriteArrayList<>();
        SessionRuntime runtime = SessionRuntime.RealTime.named("base", new SteadyClock(ProcessClock::ms));
        BoatOnTcp boat = kite(RobotKind.BOAT, ANY_PORT);
        try (Session session = Session.open(
                SessionSetup.of(TestRuns.LIBRARY.vocabulary(), project).with(runtime))) {
            session.addListener(new SessionListener() {
                @Override
                public void onNote(SessionNote note) {
                    messages.add(note.text());
                }
            });
            session.begin();
            session.fleet().connect(address(boat));
            Await.until("the boat says where it is", () -> isPlaced(session));
            boat.close();

            try (BoatOnTcp kite = kite(RobotKind.COPTER, boat.address())) {
                Await.until(
                        "it is named",
                        () -> messages.stream().anyMatch(text -> text.contains(WHY + ": no mission can command it")));
                assertThat(kite.address()).isEqualTo(boat.address());
            }
        } finally {
            boat.close();
        }
    }

    private static boolean isPlaced(Session session) {
        return session.fleet()
                .ask(boats -> boats.find("kite")
                        .filter(boat -> boat.status().pose().isPresent())
                        .isPresent())
                .toCompletableFuture()
                .join();
    }

    @Test
    void runEndsBeforeItsMissionWhereNobodyIsThereWhomItsPlanCommands() throws Exception {
        Project project = TestRuns.LIBRARY.projectOf("clv").orElseThrow();
        RunPlan plan = new RunPlan(
                TestRuns.LIBRARY.vocabulary(), project, project.plan("clv").orElseThrow());
        try (BoatOnTcp kite = copter()) {
            RunSettings settings = RunSettings.of("clv", "clv", new FleetSettings(1, 1, 20, 1))
                    .speed(Speed.REAL)
                    .limitMillis(1_000)
                    .connect(List.of(address(kite)))
                    .build();
            RunProcess process = new RunProcess(new SteadyClock(ProcessClock::ms), "base", 60_000);

            assertThatThrownBy(() -> new TcpRun(
                                    plan, settings, AnswersFile.EMPTY, ConnectedJournal.none(), process, line -> {})
                            .run(new RunObserver(now -> {}, () -> false)))
                    .isInstanceOf(UnfitRobotsException.class)
                    .hasMessage("nobody is there whom the plan can command: " + WHY);
        }
    }
}
