package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.sami.crw.event.ProxyMaps;
import org.sami.crw.proxy.ProxyCommands;
import org.sami.crw.service.Geodesy;
import org.sami.spn.engine.MissionView;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.MissionStatus;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Priority;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.BooleanValue;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.TextValue;

/** What becomes of moves of boats under a base that goes on with a mission: the engine's memory stays, and the activations are delivered again. */
class MovesAfterResumeTest {
    private static final GeoPath NEAR = to(100);
    private static final GeoPath FAR = to(6_000);

    private final ScriptedEngine engine = new ScriptedEngine(TestWorld.VOCABULARY);
    private TestWorld world = new TestWorld(engine);

    private static GeoPath to(double northM) {
        return new GeoPath(List.of(Geodesy.offset(TestWorld.HOME, 0, northM)));
    }

    @BeforeEach
    void aBoatInItsMission() {
        stands(1, "here");
        world.addBoat("a", 0, 0);
    }

    private void stands(long mission, String place) {
        engine.missions.put(
                mission,
                new MissionView(
                        mission,
                        0,
                        mission,
                        "plan",
                        "",
                        MissionStatus.RUNNING,
                        Map.of(place, List.of(new Token.Proxy("a")))));
    }

    private static Activation path(GeoPath path) {
        return new TestActivations("ProxyExecutePath")
                .with("paths", ProxyMaps.toValue(Map.of("a", path)))
                .of("a")
                .activation();
    }

    private void asks(Activation activation) {
        engine.open.add(activation);
        world.happens(engine, new Effect.Activated(activation));
    }

    /** Another process of the base goes on; its boat has not said anything yet. */
    private void resume() {
        world.drain();
        world = new TestWorld(engine);
        world.addBoat("a", 0, 0);
        world.host.resume();
        world.drain();
    }

    private ProxyCommands commands() {
        return world.boats.find("a").orElseThrow().commands();
    }

    private boolean hasCommand() {
        return commands().current().isPresent() || !commands().waiting().isEmpty();
    }

    private List<Input.AskOperator> asked() {
        return engine.inputs.stream()
                .filter(Input.AskOperator.class::isInstance)
                .map(Input.AskOperator.class::cast)
                .toList();
    }

    private void answer(boolean yes) {
        Input.AskOperator last = asked().get(asked().size() - 1);
        world.happens(engine, new Effect.QuestionAnswered(last.kind(), last.about(), yes));
        world.run(1);
    }

    private List<Occurrence> failures() {
        return engine.received("ProxyPathFailed");
    }

    @Test
    void aWayThatWasNeverCheckedIsAskedAboutBeforeItIsDriven() {
        asks(path(FAR));
        assertThat(hasCommand()).as("it has not said where it is").isFalse();

        resume();
        assertThat(hasCommand()).isFalse();
        world.run(2);

        assertThat(asked()).singleElement().extracting(Input.AskOperator::kind).isEqualTo("DoubtfulWay");
        assertThat(hasCommand()).isFalse();
    }

    @Test
    void aWayThatTheOperatorRefusedIsNotDriven() {
        world.run(1);
        asks(path(FAR));
        answer(false);
        assertThat(failures()).hasSize(1);

        resume();
        assertThat(hasCommand()).isFalse();
        world.run(5);

        assertThat(hasCommand()).isFalse();
        assertThat(world.hull("a").isAtRest()).isTrue();
        assertThat(asked()).hasSize(1);
    }

    /** A journal of an earlier version, or a base that ended between the answer and the failure. */
    @Test
    void aRefusalThatThePlanHasNotHeardOfIsToldWithoutAQuestion() {
        Activation near = path(NEAR);
        engine.step(0, new Input.Remember(1, "way/LongWay/7/a", new BooleanValue(false)), any -> {});
        engine.open.add(near);

        resume();
        world.run(5);

        assertThat(failures())
                .singleElement()
                .satisfies(failure -> assertThat(failure.values())
                        .containsEntry("reason", new TextValue("the operator does not want it")));
        assertThat(asked()).isEmpty();
        assertThat(hasCommand()).isFalse();
    }

    @Test
    void aCommandThatWasSentGoesOnAtOnceWithoutAnotherQuestion() {
        world.run(1);
        asks(path(FAR));
        answer(true);
        assertThat(hasCommand()).isTrue();

        resume();
        assertThat(commands().current()).isPresent();
        world.run(5);

        assertThat(asked()).hasSize(1);
        assertThat(world.hull("a").isAtRest()).isFalse();
    }

    @Test
    void aCommandWhoseListTheBoatTookUnderAnEarlierVersionGoesOnAtOnce() {
        engine.step(0, new Input.Remember(Ids.NONE, "list/a", new TextValue("m1-a7-a#base.0.1")), any -> {});
        engine.open.add(path(FAR));

        resume();

        assertThat(commands().current()).isPresent();
        world.run(2);
        assertThat(asked()).isEmpty();
    }

    @Test
    void aCommandThatIsOrderedAgainIsCheckedOnceTheBoatHasSaidWhereItIs() {
        world.run(1);
        asks(path(FAR));
        answer(true);
        resume();
        commands().cancel("m1-a7-a", "the operator cancelled it");
        assertThat(hasCommand()).isFalse();
        engine.step(0, new Input.Remember(1, "way/DoubtfulWay/7/a", new TextValue("nothing")), any -> {});

        world.host.redeliver(7);
        world.drain();
        assertThat(hasCommand()).isFalse();
        world.run(2);

        assertThat(asked()).hasSize(2);
        assertThat(hasCommand()).isFalse();
    }

    private Activation goTo(String type, long mission, Priority priority) {
        return new TestActivations(type)
                .id(mission + 20)
                .mission(mission)
                .priority(priority)
                .with("points", ProxyMaps.toValue(Map.of("a", Geodesy.offset(TestWorld.HOME, 0, 20))))
                .of("a")
                .activation();
    }

    private void assertNothingIsSent() {
        int before = failures().size();
        resume();
        world.run(5);
        assertThat(hasCommand()).isFalse();
        assertThat(world.hull("a").isAtRest()).isTrue();
        assertThat(failures()).as("told once").hasSize(before);
    }

    @Test
    void aCommandThatFailedIsNotSentUnlessItIsOrderedAgain() {
        world.run(1);
        asks(path(NEAR));
        commands().cancel("m1-a7-a", "the operator cancelled it");
        world.drain();
        assertThat(failures()).hasSize(1);

        assertNothingIsSent();
        world.host.redeliver(7);
        world.run(5);

        assertThat(commands().current()).isPresent();
        assertThat(world.hull("a").isAtRest()).isFalse();
        resume();
        assertThat(commands().current()).as("it was sent again").isPresent();
    }

    @Test
    void aCommandThatWasOrderedAgainAndIsAskedAboutIsStillAskedAbout() {
        world.run(1);
        asks(path(FAR));
        answer(true);
        commands().cancel("m1-a7-a", "the operator cancelled it");
        engine.step(0, new Input.Remember(1, "way/DoubtfulWay/7/a", new TextValue("nothing")), any -> {});
        world.host.redeliver(7);
        world.run(1);
        assertThat(asked()).hasSize(2);

        resume();
        world.run(2);

        assertThat(asked()).hasSize(3);
        answer(true);
        assertThat(commands().current()).isPresent();
    }

    @Test
    void aCommandThatIsUnderWayIsNotCheckedWhereOthersOfItsActivationAreOrderedAgain() {
        world.run(1);
        asks(path(FAR));
        answer(true);
        engine.step(0, new Input.Remember(1, "way/DoubtfulWay/7/a", new TextValue("nothing")), any -> {});

        world.host.redeliver(7);
        world.run(1);

        assertThat(asked()).hasSize(1);
        assertThat(commands().current()).isPresent();
    }

    @Test
    void whatAnEmergencyAbortOfAnotherMissionEndedIsNotSent() {
        stands(2, "here");
        world.run(1);
        asks(path(NEAR));
        world.run(3);
        world.happens(
                engine,
                new TestActivations("ProxyEmergencyAbort")
                        .id(9)
                        .mission(2)
                        .of("a")
                        .effect());
        assertThat(failures()).hasSize(1);

        assertNothingIsSent();
    }

    @Test
    void whatItsMissionTookBackIsNotSent() {
        world.run(1);
        asks(path(NEAR));
        world.happens(
                engine, new TestActivations("ProxyAbortMission").id(9).of("a").effect());
        assertThat(hasCommand()).isFalse();

        assertNothingIsSent();
    }

    @Test
    void whatACommandOfHigherPriorityDisplacedIsNotSent() {
        stands(2, "here");
        world.run(1);
        asks(path(NEAR));
        world.happens(engine, new Effect.Activated(goTo("ProxyGotoPoint", 2, Priority.HIGH)));
        assertThat(failures()).hasSize(1);

        assertNothingIsSent();
    }

    @Test
    void aPointThatTheBoatHasReachedIsNotDrivenToAgain() {
        world.run(1);
        asks(goTo("ProxyGotoPoint", 1, Priority.MEDIUM));
        world.run(60);
        assertThat(engine.received("ProxyPathCompleted")).hasSize(1);

        assertNothingIsSent();
        assertThat(engine.received("ProxyPathCompleted")).hasSize(1);
    }

    private static Activation leaveArea() {
        GeoArea area = new GeoArea(
                List.of(at(-40, -20), at(40, -20), at(40, 20), at(-40, 20)), List.of()); // the boat is in its middle
        return new TestActivations("ProxyLeaveArea").with("area", area).of("a").activation();
    }

    private static GeoPoint at(double eastM, double northM) {
        return Geodesy.offset(TestWorld.HOME, eastM, northM);
    }

    @Test
    void aBoatThatIsToLeaveAnAreaLeavesItOnceItHasSaidWhereItIs() {
        world.run(1);
        asks(leaveArea());
        world.run(3);
        assertThat(world.hull("a").isAtRest()).isFalse();

        resume();
        assertThat(hasCommand()).as("its way is not known").isFalse();
        world.run(60);

        assertThat(failures()).isEmpty();
        assertThat(engine.received("ProxyPathCompleted")).hasSize(1);
    }

    @Test
    void aBoatThatIsOutsideOfTheAreaOnceItHasSaidWhereItIsStays() {
        engine.open.add(leaveArea());

        resume();
        world.hull("a").drift(0, 60);
        world.run(5);

        assertThat(engine.received("ProxyPathCompleted")).hasSize(1);
        assertThat(world.hull("a").isAtRest()).isTrue();
    }

    @Test
    void anAreaThatABoatHasLeftIsNotLeftAgain() {
        world.run(1);
        asks(leaveArea());
        world.run(60);
        assertThat(engine.received("ProxyPathCompleted")).hasSize(1);

        assertNothingIsSent();
        assertThat(engine.received("ProxyPathCompleted")).hasSize(1);
    }

    @Test
    void aBoatThatIsKeptAtAPointIsKeptAgainAndNotMoved() {
        aBoatIsKeptByMission1();

        resume();
        world.run(5);

        assertThat(world.hull("a").isAtRest()).isTrue();
        assertThat(engine.received("ProxyPathCompleted")).as("told once").hasSize(1);
        assertMission2WaitsForTheBoat();
    }

    private void aBoatIsKeptByMission1() {
        stands(2, "here");
        world.run(1);
        asks(goTo("ProxyGotoPointAndBlock", 1, Priority.MEDIUM));
        world.run(60);
        assertThat(commands().queue().blockedBy()).hasValue(1L);
    }

    private void assertMission2WaitsForTheBoat() {
        world.happens(engine, new Effect.Activated(goTo("ProxyGotoPoint", 2, Priority.MEDIUM)));
        world.run(5);
        assertThat(commands().waiting()).hasSize(1);
        assertThat(world.hull("a").isAtRest()).isTrue();
    }

    @Test
    void aBoatIsKeptAgainWhenItHasLeftThePlaceThatAskedForIt() {
        aBoatIsKeptByMission1();
        engine.open.clear();

        resume();
        world.run(5);

        assertThat(commands().queue().blockedBy()).hasValue(1L);
        assertMission2WaitsForTheBoat();
        world.happens(engine, new Effect.CommandsWithdrawn(1, List.of("a")));
        assertThat(commands().current()).isPresent();

        resume();
        world.run(1);
        assertThat(commands().queue().blockedBy()).as("it was given back").isEmpty();
    }

    @Test
    void whatWaitsBehindABlockWaitsAgainThoughItComesFirst() {
        aBoatIsKeptByMission1();
        engine.open.clear();
        asks(goTo("ProxyGotoPointAndBlock", 2, Priority.HIGH));
        assertThat(commands().waiting()).hasSize(1);

        resume();

        assertThat(commands().waiting()).as("before the boat has a link").hasSize(1);
        world.run(5);
        assertThat(commands().queue().blockedBy()).hasValue(1L);
        assertThat(world.hull("a").isAtRest()).isTrue();
    }

    @Test
    void aBlockThatTheOperatorClearedDoesNotComeBack() {
        aBoatIsKeptByMission1();
        assertThat(commands().clearBlocks()).containsExactly(1L);

        resume();
        world.run(5);

        assertThat(commands().queue().blockedBy()).isEmpty();
    }

    @Test
    void aBlockOfAMissionThatEndedBesideTheBaseDoesNotComeBack() {
        aBoatIsKeptByMission1();
        engine.open.clear();
        world.drain();
        engine.missions.remove(1L);

        resume();
        world.run(5);

        assertThat(commands().queue().blockedBy()).isEmpty();
    }

    /** As {@link #resume}, with a boat that has said where it is before the base goes on. */
    private void resumeOnceLinked() {
        world.drain();
        world = new TestWorld(engine);
        world.addBoat("a", 0, 0);
        world.run(2);
        world.host.resume();
        world.run(2);
    }

    private void mission2HasItSentAgain() {
        engine.awaited.add("ProxyPathCompleted");
        stands(2, "here");
        asks(new TestActivations("ProxyResendWaypoints")
                .id(40)
                .mission(2)
                .of("a")
                .activation());
    }

    private long toldOfThatSentAgain() {
        return engine.received("ProxyPathCompleted").stream()
                .filter(answer -> answer.activation() == 40)
                .count();
    }

    @Test
    void whatWasSentAgainAndIsDoneIsNotSentAgainNorAnsweredAgain() {
        world.run(1);
        asks(goTo("ProxyGotoPoint", 1, Priority.MEDIUM));
        mission2HasItSentAgain();
        world.run(60);
        assertThat(toldOfThatSentAgain()).isEqualTo(1);
        stands(3, "here");
        asks(goTo("ProxyGotoPoint", 3, Priority.MEDIUM));

        resumeOnceLinked();

        assertThat(commands().uploads().sent()).as("of mission 3, once").isEqualTo(1);
        world.run(60);
        assertThat(engine.received("ProxyPathCompleted"))
                .extracting(Occurrence::activation)
                .containsExactly(21L, 40L, 23L);
    }

    @Test
    void whatWasSentAgainBeforeTheRestartGoesOnAndIsAnsweredWhenItIsDone() {
        world.run(1);
        asks(goTo("ProxyGotoPoint", 1, Priority.MEDIUM));
        mission2HasItSentAgain();
        world.run(1);

        resumeOnceLinked();

        assertThat(commands().uploads().sent()).isEqualTo(1);
        assertThat(toldOfThatSentAgain()).isZero();
        world.run(60);
        assertThat(toldOfThatSentAgain()).isEqualTo(1);
    }

    @Test
    void whatIsOrderedToBeSentAgainIsSent() {
        world.run(1);
        asks(goTo("ProxyGotoPoint", 1, Priority.MEDIUM));
        mission2HasItSentAgain();
        world.run(60);
        stands(3, "here");
        asks(goTo("ProxyGotoPoint", 3, Priority.MEDIUM));
        resumeOnceLinked();

        world.host.redeliver(40);
        world.run(60);

        assertThat(toldOfThatSentAgain()).isEqualTo(2);
    }
}
