package org.sami.crw.sim.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.server.testing.Await;
import org.sami.crw.message.OperatorMessage;
import org.sami.crw.operator.OperatorModels;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.operator.boat.BoatSnapshot.Commander;
import org.sami.crw.operator.decision.PendingDecision;
import org.sami.crw.operator.map.MapSnapshot;
import org.sami.crw.operator.mission.MissionsSnapshot;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.command.Upload;
import org.sami.crw.proxy.status.LinkState;
import org.sami.crw.replay.Replay;
import org.sami.crw.replay.ReplayedJournal;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.water.Water;
import org.sami.crw.session.Session;
import org.sami.crw.sim.boat.BoatOnTcp;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Priority;
import org.sami.spn.replay.TimeLine.Kind;
import org.sami.spn.replay.TimeLine.Mark;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.Value;

/** A replay shows what lay before the operator of a real session, whose boats were reached over TCP. */
@Tag("long")
@Timeout(900)
class ReplayTest {
    @TempDir
    private Path folder;

    private TestSession world;
    private Path file;
    private Session session;

    /** What the models of the session showed at a moment. */
    private record Shown(
            long atMillis,
            MissionsSnapshot missions,
            List<PendingDecision> decisions,
            List<OperatorMessage> messages,
            List<BoatSnapshot> boats) {
        static Shown of(long atMillis, OperatorModels models) {
            return new Shown(
                    atMillis,
                    models.missions().snapshot(),
                    models.decisions().snapshot(),
                    models.messages().messages(),
                    models.fleet().snapshot());
        }
    }

    /** All that a replay shows. */
    private record Everything(Shown shown, MapSnapshot map, List<Object> others) {
        static Everything of(Replay replay) {
            OperatorModels models = replay.models();
            return new Everything(
                    Shown.of(replay.shownMillis(), models),
                    models.map().snapshot(),
                    List.of(
                            models.commands().snapshot(),
                            models.interrupts().snapshot(),
                            models.alarms().snapshot(),
                            models.allocation().snapshot(),
                            models.clicks().snapshot(),
                            models.communication().snapshot(),
                            models.log().snapshot()));
        }
    }

    @BeforeEach
    void open() throws Exception {
        world = new TestSession(folder);
        file = folder.resolve("session.journal");
        session = world.opened(TestSession.library("clv"), file);
        session.begin();
    }

    @AfterEach
    void close() throws Exception {
        world.close();
    }

    private Replay replay() throws IOException {
        return new Replay(ReplayedJournal.open(file), Runnable::run, Runnable::run);
    }

    /** Waits until the models show all that the engine did, and what it says when it is asked. */
    private Shown shown() {
        OperatorModels models = session.models();
        Await.until(
                "missions say what blocks them",
                () -> models.missions().snapshot().running().stream()
                        .allMatch(mission -> !mission.details().blocked().isEmpty()));
        Await.until("boats are shown as they are", this::areBoatsShown);
        TestSession.get(models.shown());
        Shown shown = Shown.of(session.scheduler().nowMs(), models);
        Await.until("what happens next happens later", () -> session.scheduler().nowMs() > shown.atMillis());
        return shown;
    }

    /** A boat is shown ten times a second at most. */
    private boolean areBoatsShown() {
        return session.models().fleet().snapshot().stream()
                .allMatch(boat -> boat.link() == LinkState.LINKED
                        && boat.commander() == Commander.THIS_BASE
                        && boat.pose().isPresent()
                        && boat.command()
                                .equals(TestSession.get(session.fleet()
                                        .ask(boats -> boats.find(boat.boat())
                                                .orElseThrow()
                                                .commands()
                                                .current()))));
    }

    private void answer(String type, Answer answer) {
        TestSession.get(session.answer(TestSession.decision(session, type).id(), answer, "test"));
    }

    private BoatSnapshot anna() {
        return session.models().fleet().boat("anna").orElseThrow();
    }

    /** A mission that asks for boats and locations, sends the boat, and is aborted on its way. */
    private List<Shown> aMission() throws Exception {
        List<Shown> moments = new ArrayList<>();
        BoatOnTcp boat = world.boat("anna");
        TestSession.get(session.fleet().connect(TestSession.address(boat)));
        TestSession.until("anna has joined", session, view -> view.proxies().contains("anna"));
        long mission = TestSession.get(session.start("clv", "visit", Map.of()));
        TestSession.decision(session, "OperatorSelectBoatList");
        moments.add(shown());
        answer("OperatorSelectBoatList", new Answer.Proxies(List.of("anna")));
        TestSession.decision(session, "OperatorCreateLocations");
        moments.add(shown());
        List<Value> locations = List.of(GeoPoint.of(45.4002, 10.9), GeoPoint.of(45.402, 10.9));
        answer("OperatorCreateLocations", new Answer.Fields(Map.of("locations", new ListValue(locations))));
        answer("OperatorAllocationOptions", new Answer.Option(0));
        Await.until(
                "anna is under way",
                () -> Geodesy.distanceM(
                                TestSession.PIER, anna().pose().orElseThrow().position())
                        > 4);
        moments.add(shown());
        TestSession.get(session.abort(mission));
        moments.add(shown());
        return moments;
    }

    private void over() throws Exception {
        session.leave();
        session.close();
    }

    @Test
    void showsAtEachMomentWhatTheModelsHadThen() throws Exception {
        List<Shown> moments = aMission();
        over();

        Replay replay = replay();
        for (Shown then : moments) {
            replay.goTo(then.atMillis());
            Shown now = Shown.of(replay.shownMillis(), replay.models());
            assertThat(told(now.missions())).isEqualTo(told(then.missions()));
            assertThat(now.decisions()).isEqualTo(then.decisions());
            assertThat(now.messages()).isEqualTo(then.messages());
            assertThat(now.boats()).hasSize(1);
            assertSame(now.boats().get(0), then.boats().get(0));
        }
        assertThat(replay.models().fleet().snapshot().get(0).pose()).isPresent();
    }

    @Test
    void showsTheTurnsAroundWhatABoatIsToAvoid() throws Exception {
        BoatOnTcp boat = world.boat("anna");
        TestSession.get(session.fleet().connect(TestSession.address(boat)));
        Await.until("anna lies somewhere", this::areBoatsShown);
        GeoPoint behind = Geodesy.offset(TestSession.PIER, 0, 120);
        Water water = Water.of(TestSession.PIER, List.of(rock()), Optional.empty());
        TestSession.get(session.fleet()
                .ask(boats -> boats.find("anna").map(anna -> {
                    anna.commands()
                            .submit(FollowPath.goTo("around", 1, 1, behind, Priority.MEDIUM)
                                    .in(water));
                    return anna;
                })));
        Await.until("she is under way", () -> anna().why().shouldMove());
        List<GeoPoint> driven = session.models().map().snapshot().paths().get(0).points();
        long atMillis = shown().atMillis();
        over();

        Replay replay = replay();
        replay.goTo(atMillis);

        assertThat(driven).hasSizeGreaterThan(1);
        assertThat(replay.models().map().snapshot().paths().get(0).points()).isEqualTo(driven);
        assertThat(replay.models().commands().snapshot().get(0).upload())
                .map(Upload::state)
                .contains(Upload.State.READ_BACK_EQUAL);
    }

    /** Fifty metres north of the pier, forty metres wide. */
    private static GeoArea rock() {
        return new GeoArea(
                List.of(
                        Geodesy.offset(TestSession.PIER, -20, 50),
                        Geodesy.offset(TestSession.PIER, 20, 50),
                        Geodesy.offset(TestSession.PIER, 20, 70),
                        Geodesy.offset(TestSession.PIER, -20, 70)),
                List.of());
    }

    /** What effects tell of missions; what blocks them a session asks a few times a second, a replay at each moment. */
    private static List<List<Object>> told(MissionsSnapshot missions) {
        List<List<Object>> told = new ArrayList<>();
        missions.missions()
                .forEach(mission -> told.add(List.of(
                        mission.id(),
                        mission.marking(),
                        mission.outcome(),
                        mission.startedAtMillis(),
                        mission.endedAtMillis(),
                        mission.firings(),
                        mission.lastFirings(),
                        mission.variables())));
        return told;
    }

    private static void assertSame(BoatSnapshot now, BoatSnapshot then) {
        assertThat(now.boat()).isEqualTo(then.boat());
        assertThat(now.link()).isEqualTo(then.link());
        assertThat(now.command()).isEqualTo(then.command());
        assertThat(now.visited()).isEqualTo(then.visited());
        assertThat(now.points()).isEqualTo(then.points());
        assertThat(now.commander()).isEqualTo(then.commander());
        // the first pose is noted within a second
        now.pose()
                .ifPresent(pose -> assertThat(Geodesy.distanceM(
                                pose.position(), then.pose().orElseThrow().position()))
                        .as("a pose a metre is noted, once a second")
                        .isLessThan(4));
    }

    @Test
    void eachMomentShowsTheSameWhicheverWayItIsReached() throws Exception {
        List<Shown> moments = aMission();
        over();
        ReplayedJournal journal = ReplayedJournal.open(file);
        Replay once = new Replay(journal, Runnable::run, Runnable::run);
        List<Everything> forwards = new ArrayList<>();
        for (Shown moment : moments) {
            once.goTo(moment.atMillis());
            forwards.add(Everything.of(once));
        }

        Replay jumping = replay();
        for (int i : new int[] {3, 0, 2, 1, 3, 2, 0}) {
            jumping.goTo(moments.get(i).atMillis());
            assertThat(Everything.of(jumping)).as("moment " + i).isEqualTo(forwards.get(i));
        }
        assertThat(forwards.get(2).map().paths()).as("the way that anna goes").isNotEmpty();
    }

    @Test
    void timeLineMarksMissionsDecisionsAndWhatTheOperatorDid() throws Exception {
        aMission();
        over();

        List<Mark> marks = ReplayedJournal.open(file).timeLine().marks();

        assertThat(marks)
                .extracting(Mark::kind)
                .containsSubsequence(
                        Kind.MISSION_STARTED,
                        Kind.DECISION_ASKED,
                        Kind.DECISION_ANSWERED,
                        Kind.DECISION_ASKED,
                        Kind.DECISION_ANSWERED,
                        Kind.OPERATOR,
                        Kind.MISSION_ENDED);
        assertThat(marks).extracting(Mark::text).contains("visit starts", "visit is over: aborted");
        assertThat(marks).isSortedAccordingTo((a, b) -> Long.compare(a.atMillis(), b.atMillis()));
    }

    @Test
    void listenersAreToldOfAJumpOnce() throws Exception {
        aMission();
        over();
        Replay replay = replay();
        List<MissionsSnapshot> told = new ArrayList<>();
        replay.models().missions().addListener(told::add);

        replay.goTo(Long.MAX_VALUE);
        replay.goTo(0);

        assertThat(told).hasSize(2);
        assertThat(told.get(0).missions()).hasSize(1);
        assertThat(told.get(1).missions()).isEmpty();
    }

    @Test
    void journalOfASessionThatRunsIsReplayedAsFarAsItCame() throws Exception {
        List<Shown> moments = aMission();

        Replay replay = replay();
        replay.goTo(Long.MAX_VALUE);

        assertThat(replay.models().missions().snapshot().missions())
                .extracting(mission -> mission.outcome().isPresent())
                .containsExactly(true);
        assertThat(session.models().missions().snapshot())
                .as("the session goes on undisturbed")
                .isEqualTo(moments.get(3).missions());
        TestSession.get(session.start("clv", "next", Map.of()));
    }

    @Test
    void refusalNamesTheFile() throws Exception {
        Path nothing = folder.resolve("nothing.journal");
        assertThatThrownBy(() -> ReplayedJournal.open(nothing))
                .isInstanceOf(IOException.class)
                .hasMessage("there is no journal " + nothing);
        Path damaged = Files.writeString(folder.resolve("damaged.journal"), "SQLite format 3, or so it says");
        assertThatThrownBy(() -> ReplayedJournal.open(damaged))
                .isInstanceOf(IOException.class)
                .hasMessageContaining(damaged.toString());
    }
}
