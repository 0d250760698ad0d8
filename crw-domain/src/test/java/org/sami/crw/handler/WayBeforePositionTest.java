package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.sami.crw.event.ProxyMaps;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.explanation.BoatExplanation;
import org.sami.crw.service.Geodesy;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.TaskId;

/** Boats that are sent somewhere before they have said where they are. */
class WayBeforePositionTest {
    private static final GeoPath NEAR = to(100);
    private static final GeoPath FAR = to(6_000);
    private static final String QUESTION = "DoubtfulWay";

    private final ScriptedEngine engine = new ScriptedEngine(TestWorld.VOCABULARY);
    private final TestWorld world = new TestWorld(engine);

    private static GeoPath to(double northM) {
        return new GeoPath(List.of(Geodesy.offset(TestWorld.HOME, 0, northM)));
    }

    @BeforeEach
    void boatsThatSayNothingYet() {
        world.addBoat("a", 0, 0);
        world.addBoat("b", 5, 0);
    }

    private void send(Map<String, GeoPath> paths) {
        world.happens(
                engine,
                new TestActivations("ProxyExecutePath")
                        .with("paths", ProxyMaps.toValue(paths))
                        .of(paths.keySet().toArray(String[]::new))
                        .effect());
    }

    private List<Input.AskOperator> asked() {
        return engine.inputs.stream()
                .filter(Input.AskOperator.class::isInstance)
                .map(Input.AskOperator.class::cast)
                .toList();
    }

    private BoatProxy boat(String id) {
        return world.boats.find(id).orElseThrow();
    }

    private boolean hasCommand(String id) {
        return boat(id).commands().current().isPresent()
                || !boat(id).commands().waiting().isEmpty();
    }

    @Test
    void operatorIsAskedAboutAFarWayOnceTheBoatHasSaidWhereItIs() {
        send(Map.of("a", FAR));
        assertThat(hasCommand("a")).isFalse();
        assertThat(asked()).isEmpty();

        world.run(2);

        assertThat(asked()).singleElement().extracting(Input.AskOperator::kind).isEqualTo(QUESTION);
        assertThat(hasCommand("a")).isFalse();
    }

    @Test
    void nearWayIsDrivenOnceTheBoatHasSaidWhereItIs() {
        send(Map.of("a", NEAR));
        assertThat(hasCommand("a")).isFalse();

        world.run(90);

        assertThat(asked()).isEmpty();
        assertThat(engine.received("ProxyPathCompleted"))
                .extracting(Occurrence::proxies)
                .containsExactly(List.of("a"));
    }

    @Test
    void waitingIsExplained() {
        TestHull hull = world.hull("a");
        hull.isLocated = false;
        world.run(2);
        send(Map.of("a", NEAR));

        assertThat(boat("a").explain().cause()).isEqualTo(BoatExplanation.Cause.NO_POSITION);
        assertThat(boat("a").explain().text()).contains("it has not said where it is, so its way cannot be checked");
        assertThat(boat("b").explain().cause()).isNotEqualTo(BoatExplanation.Cause.NO_POSITION);
        hull.isLocated = true;
        world.run(2);
        assertThat(boat("a").explain().cause()).isNotEqualTo(BoatExplanation.Cause.NO_POSITION);
    }

    @Test
    void missionThatTakesBoatsBackTakesBackWhatWaits() {
        send(Map.of("a", NEAR));
        world.happens(engine, new Effect.CommandsWithdrawn(1, List.of("a")));

        world.run(30);

        assertThat(hasCommand("a")).isFalse();
        assertThat(world.hull("a").isAtRest()).isTrue();
    }

    private void send(GeoPath path, long activation, Priority priority) {
        world.happens(
                engine,
                new TestActivations("ProxyExecutePath")
                        .id(activation)
                        .priority(priority)
                        .with("paths", ProxyMaps.toValue(Map.of("a", path)))
                        .of("a")
                        .effect());
    }

    private List<Input.WithdrawQuestion> withdrawn() {
        return engine.inputs.stream()
                .filter(Input.WithdrawQuestion.class::isInstance)
                .map(Input.WithdrawQuestion.class::cast)
                .toList();
    }

    @Test
    void newerOrderOfTheMissionTakesThePlaceOfOneThatWaitsForTheOperator() {
        send(FAR, 11, Priority.MEDIUM);
        world.run(2);
        send(NEAR, 12, Priority.MEDIUM);
        world.run(2);

        assertThat(withdrawn())
                .singleElement()
                .extracting(Input.WithdrawQuestion::kind)
                .isEqualTo(QUESTION);
        assertThat(hasCommand("a")).isTrue();
    }

    @Test
    void criticalOrderLeavesOneThatWaitsForTheOperatorAndIsNotCritical() {
        send(FAR, 11, Priority.MEDIUM);
        world.run(2);
        send(NEAR, 12, Priority.CRITICAL);
        world.run(2);

        assertThat(withdrawn()).isEmpty();
        assertThat(hasCommand("a")).isTrue();
    }

    @Test
    void boatThatSaysLaterWhereItIsIsAskedAboutByItself() {
        world.cutLink("b", true);
        Map<String, GeoPath> paths = new LinkedHashMap<>();
        paths.put("a", FAR);
        paths.put("b", FAR);
        send(paths);
        world.run(2);
        assertThat(asked()).singleElement().asString().contains("a is to go").doesNotContain("b is to go");

        world.cutLink("b", false);
        world.run(10);
        assertThat(asked()).as("one question after the other").hasSize(1);
        world.happens(engine, answer(true));
        world.run(1);

        assertThat(hasCommand("a")).isTrue();
        assertThat(asked()).hasSize(2);
        assertThat(asked().get(1).toString()).contains("b is to go").doesNotContain("a is to go");
        assertThat(hasCommand("b")).isFalse();
        world.happens(engine, answer(false));
        world.run(1);
        assertThat(engine.received("ProxyPathFailed"))
                .extracting(Occurrence::proxies)
                .containsExactly(List.of("b"));
    }

    private Effect answer(boolean yes) {
        Input.AskOperator last = asked().get(asked().size() - 1);
        return new Effect.QuestionAnswered(last.kind(), last.about(), yes);
    }

    private static final TaskId TASK = new TaskId(1, "t1");

    private void sendByTask(GeoPoint to) {
        engine.tasks.put(TASK, Map.of());
        world.happens(
                engine,
                new TestActivations("ProxyGotoLatLon")
                        .task("t1", "a", "location", to)
                        .effect());
    }

    private void moveTaskToB() {
        world.happens(
                engine, new Effect.TasksAllocated(Map.of(TASK, Optional.of("b")), Map.of(TASK, "a"), Priority.MEDIUM));
    }

    @Test
    void moveForATaskThatAnotherBoatHasNowIsNotSent() {
        sendByTask(NEAR.points().get(0));
        moveTaskToB();

        world.run(10);

        assertThat(hasCommand("a")).isFalse();
        assertThat(world.hull("a").isAtRest()).isTrue();
        assertThat(boat("a").explain().cause()).isNotEqualTo(BoatExplanation.Cause.NO_POSITION);
        assertThat(engine.received("ProxyPathFailed")).isEmpty();
    }

    @Test
    void questionAboutATaskThatAnotherBoatHasNowIsWithdrawn() {
        world.run(1);
        sendByTask(FAR.points().get(0));
        assertThat(asked()).hasSize(1);

        moveTaskToB();

        assertThat(engine.inputs).contains(new Input.WithdrawQuestion(QUESTION, "m1-a7"));
        world.happens(engine, answer(true));
        world.run(1);
        assertThat(hasCommand("a")).isFalse();
        assertThat(engine.received("ProxyPathFailed")).isEmpty();
    }

    @Test
    void moveThatCannotBeCheckedFailsByItself() {
        GeoArea crossing =
                new GeoArea(List.of(offset(50, 50), offset(80, 80), offset(80, 50), offset(50, 80)), List.of());
        world.happens(
                engine,
                path().with("avoid", new ListValue(List.of(crossing))).effect(),
                path().id(8).mission(2).effect());

        world.run(2);

        assertThat(engine.inputs)
                .filteredOn(Input.HandlerFailed.class::isInstance)
                .singleElement()
                .extracting(failed -> ((Input.HandlerFailed) failed).activation())
                .isEqualTo(7L);
        assertThat(boat("a").commands().current().map(BoatCommand::activation)).contains(8L);
    }

    private static TestActivations path() {
        return new TestActivations("ProxyExecutePath")
                .with("paths", ProxyMaps.toValue(Map.of("a", NEAR)))
                .of("a");
    }

    private static GeoPoint offset(double eastM, double northM) {
        return Geodesy.offset(TestWorld.HOME, eastM, northM);
    }
}
