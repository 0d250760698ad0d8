package org.sami.crw.sim.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Predicate;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.sami.boat.link.BoatMode;
import org.sami.boat.server.testing.Await;
import org.sami.crw.markup.MapRelevance.Visualization;
import org.sami.crw.operator.MapModel;
import org.sami.crw.operator.map.SensorLayer;
import org.sami.crw.operator.map.ShownTrack;
import org.sami.crw.proxy.BoatStatus;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.service.Geodesy;
import org.sami.crw.session.FleetHistory;
import org.sami.crw.session.RefusedException;
import org.sami.crw.session.Session;
import org.sami.crw.session.SessionJournal;
import org.sami.crw.session.SessionListener;
import org.sami.crw.session.SessionOperator;
import org.sami.crw.session.SessionSetup;
import org.sami.crw.session.SessionTelemetry;
import org.sami.crw.sim.boat.BoatOnTcp;
import org.sami.crw.sim.hull.SensorSetting;
import org.sami.spn.engine.EngineView;
import org.sami.spn.engine.MissionView;
import org.sami.spn.journal.JournalReader;
import org.sami.spn.json.GlobalsFile;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Ids;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.Value;

/** What a window, a console and a run do with a session, on boats that are reached over TCP. */
@Timeout(120)
@Execution(ExecutionMode.CONCURRENT)
class SessionTest {
    private static final String SELECT = "OperatorSelectBoatList";

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

    private Session begun(String plan) throws Exception {
        Session session = world.opened(TestSession.library(plan));
        session.begin();
        return session;
    }

    private static List<Long> missions(Session session) {
        return TestSession.get(session.ask(
                view -> view.missions().stream().map(MissionView::id).toList()));
    }

    private static void awaitMode(Session session, String boat, BoatMode mode) {
        Await.until(
                boat + " is in mode " + mode,
                TestSession.WITHIN_S,
                () -> TestSession.get(session.fleet().boats()).stream()
                        .anyMatch(status ->
                                status.boatId().equals(boat) && status.mode().equals(Optional.of(mode))));
    }

    @Test
    void opensWithNoBoatAndRunsMissionsOnBoatsThatComeLater() throws Exception {
        Session session = begun("clv");
        BoatOnTcp anna = world.boat("anna");

        assertThat(TestSession.get(session.fleet().boats())).isEmpty();
        assertThat(TestSession.get(session.fleet().connect(TestSession.address(anna))))
                .isEqualTo("anna");
        TestSession.until("anna has joined", session, view -> view.proxies().contains("anna"));
        long first = TestSession.get(session.start("clv", "first", Map.of()));
        long second = TestSession.get(session.start("clv", "second", Map.of()));

        assertThat(missions(session)).containsExactly(first, second);
        TestSession.get(session.abort(first));
        assertThat(missions(session)).containsExactly(second);
    }

    @Test
    void refusalSaysWhyNot() throws Exception {
        Session session = begun("clv");

        assertThatThrownBy(() -> TestSession.get(session.start("clw", "first", Map.of())))
                .hasCauseInstanceOf(RefusedException.class)
                .hasMessageContaining("clw");
        assertThatThrownBy(() -> TestSession.get(session.abort(17))).hasMessageContaining("no running mission 17");
        assertThatThrownBy(() -> TestSession.get(session.answer(9, new Answer.YesNo(true), "window")))
                .hasMessageContaining("decision 9 is not open");
        assertThatThrownBy(() -> TestSession.get(session.press("alarm", Ids.NONE, List.of())))
                .hasMessageContaining("'alarm'");
        assertThatThrownBy(() -> TestSession.get(session.fleet().teleoperate("anna", 0.5, 0)))
                .hasMessageContaining("there is no boat 'anna'; there is none");
        assertThatThrownBy(() -> TestSession.get(session.fleet().teleoperate("anna", 2, 0)))
                .hasMessageContaining("-1 to 1, not 2.0");
    }

    @Test
    void resultsThatAreOpenFailWhenTheSessionCloses() throws Exception {
        Session session = begun("clv");
        CompletionStage<String> never = session.fleet().connect(BoatAddress.parse("127.0.0.1:1"));

        session.close();

        assertThatThrownBy(() -> TestSession.get(never)).hasMessageContaining("the session is closed");
        assertThatThrownBy(() -> TestSession.get(session.start("clv", "late", Map.of())))
                .hasMessageContaining("closed");
    }

    /** An operator who writes down what it hears. */
    private static final class Listening implements SessionOperator {
        private final String name;
        private final List<String> heard = new CopyOnWriteArrayList<>();

        Listening(String name) {
            this.name = name;
        }

        @Override
        public String name() {
            return name;
        }

        @Override
        public void asked(Asked asked) {
            heard.add("asked in " + asked.plan() + ": " + asked.decision().type());
        }

        @Override
        public void settled(long decision, Optional<Answer> answer, String by) {
            heard.add("answered by " + by);
        }
    }

    @Test
    void firstAnswerOfSeveralOperatorsCountsAndAllAreTold() throws Exception {
        Session session = world.opened(TestSession.library("clv"));
        Listening window = new Listening("window");
        Listening file = new Listening("answers file");
        session.addOperator(window);
        session.addOperator(file);
        session.begin();
        TestSession.get(session.fleet().connect(TestSession.address(world.boat("anna"))));
        TestSession.until("anna has joined", session, view -> view.proxies().contains("anna"));
        TestSession.get(session.start("clv", "first", Map.of()));
        Decision select = TestSession.decision(session, SELECT);

        TestSession.get(session.answer(select.id(), new Answer.Proxies(List.of("anna")), window.name()));
        assertThatThrownBy(() ->
                        TestSession.get(session.answer(select.id(), new Answer.Proxies(List.of("anna")), file.name())))
                .hasMessageContaining("is not open");

        assertThat(file.heard).startsWith("asked in clv: " + SELECT, "answered by window");
        assertThat(window.heard).containsExactlyElementsOf(file.heard);
    }

    @Test
    void boatThatWasDroppedJoinsAgainWhenItIsConnected() throws Exception {
        Session session = begun("clv");
        BoatOnTcp anna = world.boat("anna");
        TestSession.get(session.fleet().connect(TestSession.address(anna)));
        TestSession.until("anna has joined", session, view -> view.proxies().contains("anna"));

        TestSession.get(session.drop("anna"));

        List<String> left = session.host().ask(EngineView::proxies);
        assertThat(left).isEmpty();
        assertThat(TestSession.get(session.fleet().boats())).isEmpty();
        TestSession.get(session.fleet().connect(TestSession.address(anna)));
        TestSession.until(
                "anna has joined again", session, view -> view.proxies().contains("anna"));
    }

    @Test
    void fleetStopHoldsBoatsThatAreFoundLater() throws Exception {
        Session session = begun("clv");
        TestSession.get(session.fleet().connect(TestSession.address(world.boat("anna"))));
        awaitMode(session, "anna", BoatMode.STOPPED);

        assertThat(TestSession.get(session.fleet().stopAll())).containsExactly("anna");
        awaitMode(session, "anna", BoatMode.FLEET_STOP);
        TestSession.get(session.fleet().connect(TestSession.address(world.boat("bert"))));
        awaitMode(session, "bert", BoatMode.FLEET_STOP);

        assertThat(TestSession.get(session.fleet().why("bert")).text()).contains("the fleet stop is latched");
        assertThat(TestSession.get(session.fleet().releaseAll())).containsExactly("anna", "bert");
        awaitMode(session, "anna", BoatMode.STOPPED);
        awaitMode(session, "bert", BoatMode.STOPPED);
    }

    /** A plan that connects to a boat's server, then asks whether all is well. */
    private static String connecting(BoatAddress address) {
        return """
                {"formatVersion": 1, "id": "p", "name": "boats", "domain": "crw",
                 "globals": [{"name": "@meeting", "type": "point", "initial": {"lat": 45.7, "lon": 10.72}}],
                 "plans": [{"id": "p", "name": "boats",
                 "places": [
                  {"id": "a", "start": true, "outputs": [{"id": "o", "type": "ConnectExistingProxy",
                   "fields": {"name": {"value": "RED SQ"}, "server": {"value": "%s"}}}]},
                  {"id": "b", "outputs": [{"id": "q", "type": "OperatorApprove",
                   "fields": {"question": {"value": "Is all well?"}}}]},
                  {"id": "c", "end": true}],
                 "transitions": [{"id": "t", "inputs": [{"id": "i", "type": "ProxyCreated"}]},
                  {"id": "u", "inputs": [{"id": "y", "type": "YesOption"}]}],
                 "inEdges": [{"id": "e1", "place": "a", "transition": "t",
                   "requirements": [{"kind": "generic", "match": "at-least", "n": 1}]},
                  {"id": "e3", "place": "b", "transition": "u",
                   "requirements": [{"kind": "generic", "match": "at-least", "n": 1}]}],
                 "outEdges": [{"id": "e2", "transition": "t", "place": "b",
                   "requirements": [{"kind": "generic", "action": "take", "n": "all"},
                    {"kind": "relevant", "action": "add", "n": "all"}]},
                  {"id": "e4", "transition": "u", "place": "c",
                   "requirements": [{"kind": "generic", "action": "take", "n": "all"}]}]}]}
                """.formatted(address);
    }

    @Test
    void planConnectsToABoatWhileTheSessionRuns() throws Exception {
        BoatAddress anna = TestSession.address(world.boat("anna"));
        Session session = world.opened(TestSession.project(connecting(anna)));
        session.begin();

        TestSession.get(session.start("p", "first", Map.of()));

        TestSession.decision(session, "OperatorApprove");
        List<String> joined = session.host().ask(EngineView::proxies);
        assertThat(joined).containsExactly("anna");
        TestSession.get(session.start("p", "second", Map.of())); // the boat is there already
        TestSession.until("both ask", session, view -> view.decisions().size() == 2);
    }

    @Test
    void resumedSessionHasItsMissionsBoatsAndGlobals() throws Exception {
        BoatAddress anna = TestSession.address(world.boat("anna"));
        Path journal = folder.resolve("session.journal");
        Session session = world.opened(TestSession.project(connecting(anna)), journal);
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
        assertThat(again.reconnect()).containsExactly("anna");
        again.begin();

        assertThat(missions(again)).containsExactly(first, second);
        Optional<Value> meeting = again.host().ask(view -> view.variable(Ids.NONE, "@meeting"));
        assertThat(meeting).contains(TestSession.PIER);
        Await.until(
                "anna is watched",
                TestSession.WITHIN_S,
                () -> TestSession.get(again.fleet().why("anna")).text().contains("another client commands the boat"));
        TestSession.get(again.fleet().takeCommand("anna"));
        Await.until(
                "anna is commanded",
                TestSession.WITHIN_S,
                () -> TestSession.get(again.fleet()
                        .ask(boats -> boats.find("anna").orElseThrow().isCommanding())));
        Decision asked = TestSession.decision(again, "OperatorApprove");
        TestSession.get(again.answer(asked.id(), new Answer.YesNo(true), "window"));
        assertThat(missions(again)).containsExactly(second);
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
        Await.until("anna's pose is in the journal", TestSession.WITHIN_S, () -> hasPose(journal));
        SensorLayer measured = heatMap(session);
        session.close();

        Session again = world.resumed(journal);
        again.begin();
        SensorLayer restored = heatMap(again);
        assertThat(restored.channel()).isEqualTo(measured.channel());
        assertThat(restored.grid().least()).isCloseTo(measured.grid().least(), within(0.1));
        Await.until(
                "the track is back, without the boat",
                TestSession.WITHIN_S,
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
        Await.until(
                "something was measured",
                TestSession.WITHIN_S,
                () -> !map.snapshot().channels().isEmpty());
        map.showData(map.snapshot().channels().get(0), Optional.of(Visualization.HEATMAP));
        Await.until(
                "it is drawn",
                TestSession.WITHIN_S,
                () -> !map.snapshot().data().isEmpty());
        return map.snapshot().data().get(0);
    }

    @Test
    void mendedPlanRunsBesideMissionsOfTheOldOneAlsoAfterAResume() throws Exception {
        BoatAddress anna = TestSession.address(world.boat("anna"));
        Path journal = folder.resolve("session.journal");
        Session session = world.opened(TestSession.project(connecting(anna)), journal);
        session.begin();
        long old = TestSession.get(session.start("p", "old", Map.of()));
        TestSession.decision(session, "OperatorApprove");

        String mended = connecting(anna).replace("Is all well?", "Is all very well?");
        assertThat(TestSession.get(session.load(TestSession.project(mended)))).isEqualTo(2);
        assertThatThrownBy(() ->
                        TestSession.get(session.load(TestSession.project(mended.replace("\"start\": true, ", "")))))
                .hasMessageContaining("the project is not loaded");
        TestSession.get(session.start("p", "new", Map.of()));
        TestSession.until("both ask", session, view -> view.decisions().size() == 2);
        session.close();
        Session again = world.resumed(journal);
        again.reconnect();
        again.begin();
        TestSession.get(again.start("p", "newer", Map.of()));

        TestSession.until("all ask", again, view -> view.decisions().size() == 3);
        List<String> prompts = again.host()
                .ask(view -> view.decisions().stream().map(Decision::prompt).toList());
        assertThat(prompts).containsExactly("Is all well?", "Is all very well?", "Is all very well?");
        assertThat(missions(again)).contains(old);
    }

    @Test
    void simulatedBoatsAreReachedAsAnyOther() throws Exception {
        Session session = begun("clv");

        List<String> boats = TestSession.get(session.fleet().addSimulated("sim", TestSession.PIER, 2));

        assertThat(boats).containsExactly("sim1", "sim2");
        TestSession.until("both have joined", session, view -> view.proxies().containsAll(boats));
        assertThat(TestSession.get(session.fleet().boats()))
                .map(BoatStatus::boatId)
                .containsAll(new ArrayList<>(boats));
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
        assertThat(again.reconnect()).containsExactly("sim1");
        again.begin();

        GeoPoint here = awaitPosition(again, "sim1", at -> true);
        assertThat(Geodesy.distanceM(there, here)).isLessThan(3);
        assertThat(Geodesy.distanceM(TestSession.PIER, here)).isGreaterThan(3);
        assertThat(TestSession.get(again.ask(EngineView::proxies))).containsExactly("sim1");
    }

    /** Drives a boat by hand until it is some metres away. Gives where it is told to be then. */
    private static GeoPoint drivenAway(Session session, String boat) {
        return awaitPosition(session, boat, at -> {
            TestSession.get(session.fleet().teleoperate(boat, 1, 0));
            return Geodesy.distanceM(TestSession.PIER, at) > 6;
        });
    }

    private static GeoPoint awaitPosition(Session session, String boat, Predicate<GeoPoint> wanted) {
        Await.until(
                boat + " is there",
                TestSession.WITHIN_S,
                () -> session.fleet().history().last(boat).map(FleetHistory.Told::position).stream()
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
            again.reconnect();

            Await.until("it is told", TestSession.WITHIN_S, () -> !notices.isEmpty());
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
                public void pose(long atMillis, String boat, FleetHistory.Told told, double distanceM) {
                    track.add(told.position());
                }
            });
        }

        assertThat(track).hasSizeBetween(3, 60);
        assertThat(Geodesy.distanceM(track.get(0), TestSession.PIER)).isLessThan(5);
        assertThat(Geodesy.distanceM(track.get(track.size() - 1), there)).isLessThan(5);
    }

    @Test
    void globalsAreSavedToTheProjectsFileAndLoadedFromIt() throws Exception {
        Path file = folder.resolve("project.json");
        Project project = TestSession.project(connecting(TestSession.address(world.boat("anna"))));
        Session session = world.opened(project);
        session.begin();
        Files.writeString(file, new ProjectWriter(session.setup().vocabulary()).text(project));
        TestSession.get(session.setVariable(Ids.NONE, "@meeting", TestSession.PIER));

        assertThat(TestSession.get(session.saveGlobals(file)).changes())
                .extracting(GlobalsFile.Change::name)
                .containsExactly("@meeting");

        assertThat(Files.readString(file)).contains("45.4").doesNotContain("45.7");
        assertThat(TestSession.get(session.saveGlobals(file)).changes()).isEmpty();
        assertThat(TestSession.get(session.load(file))).isEqualTo(2);
        assertThatThrownBy(() -> TestSession.get(session.saveGlobals(folder.resolve("none.json"))))
                .hasRootCauseInstanceOf(RefusedException.class)
                .hasMessageContaining("nothing is saved");
        Files.writeString(file, "{");
        assertThatThrownBy(() -> TestSession.get(session.load(file))).hasMessageContaining("the project is not loaded");
    }
}
