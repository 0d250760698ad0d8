package org.sami.crw.sim.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Predicate;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.sami.boat.server.testing.Await;
import org.sami.crw.markup.MapRelevance.Visualization;
import org.sami.crw.operator.MapModel;
import org.sami.crw.operator.map.SensorLayer;
import org.sami.crw.operator.map.ShownTrack;
import org.sami.crw.operator.mission.MissionSnapshot;
import org.sami.crw.proxy.ProxyCommands;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.service.Geodesy;
import org.sami.crw.session.Session;
import org.sami.crw.session.SessionListener;
import org.sami.crw.session.SessionSetup;
import org.sami.crw.session.archive.SessionJournal;
import org.sami.crw.sim.boat.BoatOnTcp;
import org.sami.crw.sim.hull.SensorSetting;
import org.sami.session.api.RefusedException;
import org.sami.session.record.FleetHistory;
import org.sami.session.record.SessionTelemetry;
import org.sami.spn.engine.EngineView;
import org.sami.spn.journal.JournalReader;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Ids;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.Value;

/** What a session takes up from the journal of an earlier one, on boats that are reached over TCP. */
@Timeout(900)
@Execution(ExecutionMode.CONCURRENT)
class SessionResumeTest {
    private static final String FAR = """
        {"formatVersion": 1, "id": "p", "name": "far", "domain": "crw", "plans": [{"id": "far", "name": "far", "places": [
           {"id": "go", "name": "Go there", "start": true, "outputs": [{"id": "way", "type": "ProxyExecutePath",
            "fields": {"paths": {"value": {"anna": [{"lat": 45.46, "lon": 10.9}]}}}}]},
           {"id": "there", "name": "There", "end": true}],
          "transitions": [{"id": "t", "inputs": [{"id": "i", "type": "ProxyPathCompleted"}]}],
          "inEdges": [{"id": "a", "place": "go", "transition": "t",
           "requirements": [{"match": "all", "kind": "relevant"}]}],
          "outEdges": [{"id": "b", "transition": "t", "place": "there",
           "requirements": [{"action": "take", "n": "all", "kind": "relevant"}]}]}]}
        """;

    @TempDir
    private Path folder;

    private TestSession world;

    @BeforeEach
    void open() {
        world = new TestSession(folder);
    }

    @AfterEach
    void close() throws Exception {
        world.close();
    }

    @Test
    void resumedSessionHasItsMissionsBoatsAndGlobals() throws Exception {
        BoatAddress anna = TestSession.address(world.boat("anna"));
        Path journal = folder.resolve("session.journal");
        Session session = world.opened(TestSession.project(TestSession.connecting(anna)), journal);
        session.begin();
        long first = TestSession.get(session.start("p", "first", Map.of()));
        long second = TestSession.get(session.start("p", "second", Map.of()));
        TestSession.until("both ask", session, view -> view.decisions().size() == 2);
        TestSession.get(session.setVariable(Ids.NONE, "@meeting", TestSession.PIER));
        TestSession.get(session.fleet().connect(TestSession.address(world.boat("bert"))));
        TestSession.until("bert has joined", session, view -> view.proxies().contains("bert"));
        TestSession.get(session.drop("bert"));
        TestSession.get(session.fleet().handOver("anna"));
        TestSession.get(session.ask(EngineView::proxies)); // behind what the hand-over had remembered
        session.close();

        Session again = world.resumed(journal);
        assertThat(again.earlierBoats().reconnect()).containsExactly("anna");
        again.begin();

        assertThat(TestSession.missions(again)).containsExactly(first, second);
        Optional<Value> meeting = again.host().ask(view -> view.variable(Ids.NONE, "@meeting"));
        assertThat(meeting).contains(TestSession.PIER);
        Await.until(
                "anna is watched",
                () -> TestSession.get(again.fleet().why("anna")).text().contains("another client commands the boat"));
        TestSession.get(again.fleet().takeCommand("anna"));
        Await.until(
                "anna is commanded",
                () -> TestSession.get(again.fleet()
                        .ask(boats -> boats.find("anna").orElseThrow().isCommanding())));
        Decision asked = TestSession.decision(again, "OperatorApprove");
        TestSession.get(again.answer(asked.id(), new Answer.YesNo(true), "window"));
        assertThat(TestSession.missions(again)).containsExactly(second);
    }

    @Test
    void farWayThatWasAskedAboutIsNotDrivenUnderTheNextBaseUntilTheOperatorHasAnswered() throws Exception {
        BoatOnTcp anna = world.boat("anna");
        Path journal = folder.resolve("far.journal");
        Session session = world.opened(TestSession.project(FAR), journal);
        session.begin();
        TestSession.get(session.fleet().connect(TestSession.address(anna)));
        TestSession.until("anna has joined", session, view -> view.proxies().contains("anna"));
        TestSession.get(session.start("far", "far", Map.of()));
        TestSession.decision(session, "DoubtfulWay");
        session.close();

        Session again = world.resumed(journal);
        again.earlierBoats().reconnect();
        again.begin();
        awaitPosition(again, "anna", at -> true);

        Decision asked = TestSession.decision(again, "DoubtfulWay");
        assertThat(commands(again, "anna")).isZero();
        TestSession.get(again.answer(asked.id(), new Answer.YesNo(true), "window"));
        Await.until("anna has its path", () -> commands(again, "anna") == 1);
    }

    @Test
    void commandThatFailedIsSentUnderTheNextBaseOnlyWhenTheOperatorSendsItAgain() throws Exception {
        BoatOnTcp anna = world.boat("anna");
        Path journal = folder.resolve("failed.journal");
        Session session = world.opened(TestSession.project(FAR.replace("45.46", "45.404")), journal);
        session.begin();
        TestSession.get(session.fleet().connect(TestSession.address(anna)));
        TestSession.until("anna has joined", session, view -> view.proxies().contains("anna"));
        awaitPosition(session, "anna", at -> true);
        long mission = TestSession.get(session.start("far", "far", Map.of()));
        Await.until("anna has its path", () -> commands(session, "anna") == 1);
        String command = TestSession.get(session.fleet()
                .ask(boats -> boats.find("anna")
                        .orElseThrow()
                        .commands()
                        .current()
                        .orElseThrow()
                        .commandId()));
        TestSession.get(session.fleet().cancel("anna", command));
        Await.until("it is stuck", () -> snapshot(session, mission).stuck().isPresent());
        session.close();

        Session again = world.resumed(journal);
        again.earlierBoats().reconnect();
        again.begin();
        awaitPosition(again, "anna", at -> true);
        Await.until("it is stuck still", () -> snapshot(again, mission).stuck().isPresent());

        assertThat(commands(again, "anna")).isZero();
        assertThat(snapshot(again, mission).stuck().orElseThrow().what())
                .isEqualTo("anna cannot go on in 'Go there': the operator cancelled it");
        TestSession.get(again.sendAgain(mission));
        Await.until("anna has its path again", () -> commands(again, "anna") == 1);
    }

    private static int commands(Session session, String boat) {
        return TestSession.get(session.fleet().ask(boats -> {
            ProxyCommands commands = boats.find(boat).orElseThrow().commands();
            return commands.waiting().size() + (commands.current().isPresent() ? 1 : 0);
        }));
    }

    @Test
    void aMissionHasRunSinceItBeganAndHasItsFiringsAfterAResume() throws Exception {
        BoatAddress anna = TestSession.address(world.boat("anna"));
        Path journal = folder.resolve("session.journal");
        Session session = world.opened(TestSession.project(TestSession.connecting(anna)), journal);
        session.begin();
        long mission = TestSession.get(session.start("p", "first", Map.of()));
        TestSession.until("it asks", session, view -> view.decisions().size() == 1);
        Await.until("its firing is shown", () -> snapshot(session, mission).firings() == 1);
        MissionSnapshot before = snapshot(session, mission);
        session.close();

        Session again = world.resumed(journal);
        again.begin();

        Await.until(
                "the mission is shown",
                () -> again.models().missions().snapshot().mission(mission).isPresent());
        assertThat(snapshot(again, mission).startedAtMillis()).isEqualTo(before.startedAtMillis());
        assertThat(snapshot(again, mission).firings()).isEqualTo(1);
    }

    private static MissionSnapshot snapshot(Session session, long mission) {
        return session.models().missions().snapshot().mission(mission).orElseThrow();
    }

    private static boolean hasPose(Path journal) {
        try (JournalReader reader = JournalReader.open(journal)) {
            return reader.telemetry().rows().stream()
                    .anyMatch(row -> row.kind().equals("pose") && row.proxy().equals("anna"));
        } catch (IOException notYet) {
            return false;
        }
    }

    @Test
    void tracksAndWhatWasMeasuredAreOnTheMapAgainAfterAResume() throws Exception {
        Path journal = folder.resolve("tracks.journal");
        Session session = world.opened(TestSession.library("clv"), journal);
        session.begin();
        BoatOnTcp anna = world.boat("anna", SensorSetting.parse("oxygen@5"));
        TestSession.get(session.fleet().connect(TestSession.address(anna)));
        Await.until("anna's pose is in the journal", () -> hasPose(journal));
        SensorLayer measured = heatMap(session);
        session.close();

        Session again = world.resumed(journal);
        again.begin();
        SensorLayer restored = heatMap(again);
        assertThat(restored.channel()).isEqualTo(measured.channel());
        assertThat(restored.grid().least()).isCloseTo(measured.grid().least(), within(0.1));
        Await.until(
                "the track is back, without the boat",
                () -> !again.models().map().snapshot().tracks().isEmpty());

        ShownTrack track = again.models().map().snapshot().tracks().get(0);
        assertThat(track.boat()).isEqualTo("anna");
        assertThat(Geodesy.distanceM(track.points().get(0).position(), TestSession.PIER))
                .isLessThan(5);
        assertThat(TestSession.get(again.fleet().boats())).isEmpty();
    }

    /** What was measured first, as it is drawn. */
    private static SensorLayer heatMap(Session session) {
        MapModel map = session.models().map();
        Await.until("something was measured", () -> !map.snapshot().channels().isEmpty());
        map.showData(map.snapshot().channels().get(0), Optional.of(Visualization.HEATMAP));
        Await.until("it is drawn", () -> !map.snapshot().data().isEmpty());
        return map.snapshot().data().get(0);
    }

    @Test
    void mendedPlanRunsBesideMissionsOfTheOldOneAlsoAfterAResume() throws Exception {
        BoatAddress anna = TestSession.address(world.boat("anna"));
        Path journal = folder.resolve("session.journal");
        Session session = world.opened(TestSession.project(TestSession.connecting(anna)), journal);
        session.begin();
        long old = TestSession.get(session.start("p", "old", Map.of()));
        TestSession.decision(session, "OperatorApprove");

        String mended = TestSession.connecting(anna).replace("Is all well?", "Is all very well?");
        assertThat(TestSession.get(session.project().load(TestSession.project(mended))))
                .isEqualTo(2);
        assertThatThrownBy(() -> TestSession.get(
                        session.project().load(TestSession.project(mended.replace("\"start\": true, ", "")))))
                .hasMessageContaining("the project is not loaded");
        TestSession.get(session.start("p", "new", Map.of()));
        TestSession.until("both ask", session, view -> view.decisions().size() == 2);
        session.close();
        Session again = world.resumed(journal);
        again.earlierBoats().reconnect();
        again.begin();
        TestSession.get(again.start("p", "newer", Map.of()));

        TestSession.until("all ask", again, view -> view.decisions().size() == 3);
        List<String> prompts = again.host()
                .ask(view -> view.decisions().stream().map(Decision::prompt).toList());
        assertThat(prompts).containsExactly("Is all well?", "Is all very well?", "Is all very well?");
        assertThat(TestSession.missions(again)).contains(old);
    }

    @Test
    void simulatedBoatsComeBackWhereTheyWereWhenASessionIsResumed() throws Exception {
        Path journal = folder.resolve("session.journal");
        Session session = world.opened(TestSession.library("clv"), journal);
        session.begin();
        TestSession.get(session.fleet().addSimulated("sim", TestSession.PIER, 2));
        TestSession.until("both have joined", session, view -> view.proxies().size() == 2);
        TestSession.get(session.drop("sim2"));
        GeoPoint there = drivenAway(session, "sim1");
        session.leave();
        session.close();

        Session again = world.resumed(journal);
        assertThat(again.earlierBoats().reconnect()).containsExactly("sim1");
        again.begin();

        GeoPoint here = awaitPosition(again, "sim1", at -> true);
        assertThat(Geodesy.distanceM(there, here)).isLessThan(3);
        assertThat(Geodesy.distanceM(TestSession.PIER, here)).isGreaterThan(3);
        assertThat(TestSession.get(again.ask(EngineView::proxies))).containsExactly("sim1");
    }

    /** Drives a boat by hand until it is some metres away. Gives where it is told to be then. */
    private static GeoPoint drivenAway(Session session, String boat) {
        return awaitPosition(
                session, boat, at -> isSteered(session, boat) && Geodesy.distanceM(TestSession.PIER, at) > 6);
    }

    /** Steers a boat by hand; not while its link is lost, as it may be for a moment on a busy machine. */
    private static boolean isSteered(Session session, String boat) {
        try {
            TestSession.get(session.fleet().teleoperate(boat, 1, 0));
            return true;
        } catch (CompletionException refused) {
            assertThat(refused).hasCauseInstanceOf(RefusedException.class);
            return false;
        }
    }

    private static GeoPoint awaitPosition(Session session, String boat, Predicate<GeoPoint> wanted) {
        Await.until(
                boat + " is there",
                () -> session.fleet().history().last(boat).map(FleetHistory.Report::position).stream()
                        .anyMatch(wanted));
        return session.fleet().history().last(boat).orElseThrow().position();
    }

    @Test
    void resumeSaysWhichSimulatedBoatsAreMissingWhereNobodySimulates() throws Exception {
        Path journal = folder.resolve("session.journal");
        Session session = world.opened(TestSession.library("clv"), journal);
        session.begin();
        TestSession.get(session.fleet().addSimulated("sim", TestSession.PIER, 1));
        TestSession.until("it has joined", session, view -> view.proxies().size() == 1);
        session.close();
        List<String> notices = new CopyOnWriteArrayList<>();

        try (Session again = Session.open(SessionSetup.resumed(SessionJournal.open(journal)))) {
            again.addListener(new SessionListener() {
                @Override
                public void onNotice(String text) {
                    notices.add(text);
                }
            });
            again.earlierBoats().reconnect();

            Await.until("it is told", () -> !notices.isEmpty());
            assertThat(notices)
                    .containsExactly(
                            "sim was simulated by an earlier process and is missing: this session has nobody who "
                                    + "makes simulated boats; connect a boat of that name, or drop it");
        }
    }

    @Test
    void tracksOfBoatsAreInTheJournal() throws Exception {
        Path journal = folder.resolve("session.journal");
        Session session = world.opened(TestSession.library("clv"), journal);
        session.begin();
        TestSession.get(session.fleet().addSimulated("sim", TestSession.PIER, 1));
        awaitPosition(session, "sim", at -> true);
        GeoPoint there = drivenAway(session, "sim");
        session.leave();
        session.close();

        List<GeoPoint> track = new ArrayList<>();
        try (SessionJournal read = SessionJournal.open(journal)) {
            SessionTelemetry.read(read.earlier(), new SessionTelemetry.Reader() {
                @Override
                public void pose(long atMillis, String boat, FleetHistory.Report report, double distanceM) {
                    track.add(report.position());
                }
            });
        }

        assertThat(track).hasSizeGreaterThan(2);
        assertThat(Geodesy.distanceM(track.get(0), TestSession.PIER)).isLessThan(5);
        assertThat(Geodesy.distanceM(track.get(track.size() - 1), there)).isLessThan(5);
    }
}
