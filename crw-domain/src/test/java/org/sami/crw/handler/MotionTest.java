package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.sami.crw.event.ProxyMaps;
import org.sami.crw.message.OperatorMessage;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.service.Geodesy;
import org.sami.spn.engine.MissionView;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.MissionStatus;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Priority;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/** Commands on their way from an activation to a real boat server and back. */
class MotionTest {
    private static final GeoPath NORTH = path(0, 30, 0, 60, 0, 90);
    private static final GeoPath EAST = path(30, 0, 60, 0);

    private final ScriptedEngine engine = new ScriptedEngine(TestWorld.VOCABULARY);
    private final TestWorld world = new TestWorld(engine);

    @BeforeEach
    void twoBoats() {
        world.addBoat("a", 0, 0);
        world.addBoat("b", 5, 0);
        world.run(1);
    }

    @Test
    void eachBoatFollowsItsOwnPathAndAnswersForItself() {
        Map<String, GeoPath> paths = new LinkedHashMap<>();
        paths.put("a", NORTH);
        paths.put("b", EAST);

        world.happens(engine, executePath(paths).of("a", "b").effect());
        world.run(180);

        assertThat(engine.received("ProxyPathCompleted"))
                .extracting(Occurrence::proxies, Occurrence::tasks, Occurrence::activation, Occurrence::mission)
                .containsExactly(tuple(List.of("b"), List.of(), 7L, 1L), tuple(List.of("a"), List.of(), 7L, 1L));
        assertThat(distance("a", NORTH.points().get(2))).isLessThan(6);
        assertThat(distance("b", EAST.points().get(1))).isLessThan(6);
    }

    @Test
    void aBoatWithoutAPathCompletesAtOnce() {
        world.happens(engine, executePath(Map.of("a", NORTH)).of("a", "b").effect());

        assertThat(engine.received("ProxyPathCompleted"))
                .extracting(Occurrence::proxies)
                .containsExactly(List.of("b"));
    }

    @Test
    void aPathThatIsActivatedAgainGoesOnAtItsFirstUnvisitedLocation() {
        world.happens(engine, executePath(Map.of("a", NORTH)).of("a").effect());
        runUntilProgress(1);
        world.happens(engine, new Effect.CommandsWithdrawn(1, List.of("a")));
        world.run(5);
        assertThat(world.hull("a").isAtRest()).isTrue();

        world.happens(engine, executePath(Map.of("a", NORTH)).id(8).of("a").effect());
        assertThat(world.boats.find("a").orElseThrow().commands().visitedCount("m1-a8-a"))
                .contains(1);
        world.run(150);

        assertThat(engine.received("ProxyPathCompleted"))
                .extracting(Occurrence::activation)
                .containsExactly(8L);
    }

    @Test
    void aPathOfWhichNothingIsLeftCompletesAtOnce() {
        world.happens(engine, executePath(Map.of("b", EAST)).of("b").effect());
        world.run(120);
        int before = engine.received("ProxyPathCompleted").size();

        world.happens(engine, executePath(Map.of("b", EAST)).id(8).of("b").effect());

        assertThat(engine.received("ProxyPathCompleted")).hasSize(before + 1);
    }

    @Test
    void progressIsThatOfOneMissionPathAndBoat() {
        world.happens(engine, executePath(Map.of("b", EAST)).of("b").effect());
        world.run(120);
        int before = engine.received("ProxyPathCompleted").size();

        world.happens(
                engine,
                executePath(Map.of("b", EAST)).id(8).mission(2).of("b").effect(),
                executePath(Map.of("a", EAST)).id(9).of("a").effect());

        assertThat(engine.received("ProxyPathCompleted")).hasSize(before);
        assertThat(world.boats.find("b").orElseThrow().commands().visitedCount("m2-a8-b"))
                .contains(0);
        assertThat(world.boats.find("a").orElseThrow().commands().visitedCount("m1-a9-a"))
                .contains(0);
    }

    @Test
    void aPointIsGoneToAgainEachTime() {
        Value points = ProxyMaps.toValue(Map.of("b", EAST.points().get(0)));
        world.happens(
                engine,
                new TestActivations("ProxyGotoPoint")
                        .with("points", points)
                        .of("b")
                        .effect());
        world.run(60);
        world.happens(
                engine,
                new TestActivations("ProxyGotoPoint")
                        .id(8)
                        .with("points", points)
                        .of("b")
                        .effect());

        assertThat(engine.received("ProxyPathCompleted")).hasSize(1);
        world.run(10);
        assertThat(engine.received("ProxyPathCompleted")).hasSize(2);
    }

    @Test
    void allBoatsGoToOneLocation() {
        world.happens(
                engine,
                new TestActivations("ProxyGotoLatLon")
                        .with("location", EAST.points().get(0))
                        .of("a", "b")
                        .effect());
        world.run(90);

        assertThat(engine.received("ProxyPathCompleted")).hasSize(2);
        assertThat(distance("a", EAST.points().get(0))).isLessThan(6);
    }

    @Test
    void aTaskSendsItsBoatAndIsNamedInTheAnswer() {
        world.happens(
                engine,
                new TestActivations("ProxyGotoLatLon")
                        .task("t1", "b", "location", EAST.points().get(0))
                        .effect());
        world.run(60);

        assertThat(engine.received("ProxyPathCompleted"))
                .extracting(Occurrence::proxies, Occurrence::tasks)
                .containsExactly(tuple(List.of("b"), List.of(new TaskId(1, "t1"))));
    }

    @Test
    void aWithdrawalStopsTheBoatAndNothingIsAnswered() {
        world.happens(engine, executePath(Map.of("a", NORTH)).of("a").effect());
        world.run(8);
        assertThat(world.hull("a").isAtRest()).isFalse();

        world.happens(engine, new Effect.CommandsWithdrawn(1, List.of()));
        world.run(5);

        assertThat(world.hull("a").isAtRest()).isTrue();
        assertThat(world.boats.find("a").orElseThrow().commands().current()).isEmpty();
        assertThat(engine.received("ProxyPathCompleted")).isEmpty();
        assertThat(engine.received("ProxyPathFailed")).isEmpty();
    }

    @Test
    void theSameStepMayWithdrawAndCommandAnew() {
        world.happens(engine, executePath(Map.of("a", NORTH)).of("a").effect());
        world.run(5);

        world.happens(
                engine,
                new Effect.CommandsWithdrawn(1, List.of("a")),
                executePath(Map.of("a", EAST)).id(8).of("a").effect());

        assertThat(world.boats.find("a").orElseThrow().commands().current().map(BoatCommand::activation))
                .contains(8L);
    }

    @Test
    void whatAStepAsksAndThenWithdrawsReachesNoBoat() {
        world.happens(
                engine,
                executePath(Map.of("a", NORTH, "b", EAST)).of("a", "b").effect(),
                executePath(Map.of("a", NORTH)).id(8).mission(2).of("a").effect(),
                new Effect.CommandsWithdrawn(1, List.of("a")),
                executePath(Map.of("a", NORTH)).id(9).mission(3).of("a").effect(),
                new Effect.CommandsWithdrawn(3, List.of()));

        assertThat(world.boats.find("a").orElseThrow().commands().current().map(BoatCommand::activation))
                .contains(8L);
        assertThat(world.boats.find("a").orElseThrow().commands().waiting()).isEmpty();
        assertThat(world.boats.find("b").orElseThrow().commands().current().map(BoatCommand::activation))
                .contains(7L);
    }

    @Test
    void anActivationThatIsDeliveredAgainCommandsOnceAndOnlyWhoIsStillThere() {
        TestActivations asking = executePath(Map.of("a", NORTH, "b", EAST)).of("a", "b");
        engine.open.add(asking.activation());
        engine.missions.put(
                1L,
                new MissionView(
                        1, 0, 1, "plan", "", MissionStatus.RUNNING, Map.of("here", List.of(new Token.Proxy("a")))));

        world.host.resume();
        world.run(2);

        assertThat(world.boats.find("a").orElseThrow().commands().current().map(BoatCommand::commandId))
                .contains("m1-a7-a");
        assertThat(world.boats.find("b").orElseThrow().commands().current()).isEmpty();
        assertThat(engine.received("ProxyPathCompleted")).isEmpty();
    }

    @Test
    void aCommandWaitsWhileTheLinkIsLost() {
        world.cutLinks(true);
        world.run(5);
        world.happens(engine, executePath(Map.of("b", EAST)).of("b").effect());
        world.run(30);
        assertThat(engine.received("ProxyPathFailed")).isEmpty();
        assertThat(messages()).anyMatch(text -> text.contains("link to b is lost"));

        world.cutLinks(false);
        world.run(120);

        assertThat(engine.received("ProxyPathCompleted")).hasSize(1);
    }

    @Test
    void anUnknownBoatFailsWithAReason() {
        world.happens(engine, executePath(Map.of("ghost", NORTH)).of("ghost").effect());

        Occurrence failed = engine.received("ProxyPathFailed").get(0);
        assertThat(failed.proxies()).containsExactly("ghost");
        assertThat(failed.values()).containsEntry("reason", new TextValue("no boat of that name is known"));
        assertThat(messages()).anyMatch(text -> text.contains("ghost"));
    }

    @Test
    void aDisplacedCommandFailsAndOneThatIsOnlyInterruptedReturns() {
        world.happens(engine, executePath(Map.of("a", NORTH)).of("a").effect());
        world.run(3);
        world.happens(
                engine,
                new TestActivations("ProxyGotoLatLon")
                        .id(8)
                        .mission(2)
                        .priority(Priority.CRITICAL)
                        .with("location", EAST.points().get(0))
                        .of("a")
                        .effect());
        assertThat(engine.received("ProxyPathFailed")).isEmpty();
        world.happens(
                engine,
                new TestActivations("ProxyGotoLatLon")
                        .id(9)
                        .mission(3)
                        .with("location", EAST.points().get(1))
                        .of("b")
                        .effect());
        world.run(1);
        world.happens(
                engine,
                new TestActivations("ProxyGotoLatLon")
                        .id(10)
                        .mission(4)
                        .priority(Priority.HIGH)
                        .with("location", EAST.points().get(0))
                        .of("b")
                        .effect());

        assertThat(engine.received("ProxyPathFailed"))
                .extracting(Occurrence::mission)
                .containsExactly(3L);
        world.run(240);
        assertThat(engine.received("ProxyPathCompleted"))
                .extracting(Occurrence::mission)
                .containsExactlyInAnyOrder(2L, 1L, 4L);
    }

    @Test
    void aBlockKeepsTheBoatForItsMissionUntilThatEnds() {
        engine.missions.put(1L, new MissionView(1, 0, 1, "plan", "", MissionStatus.RUNNING, Map.of()));
        world.happens(engine, new TestActivations("BlockMovement").of("a").effect());
        world.run(2);
        world.happens(
                engine,
                new TestActivations("ProxyGotoLatLon")
                        .id(8)
                        .mission(2)
                        .with("location", NORTH.points().get(0))
                        .of("a")
                        .effect());
        world.run(20);
        assertThat(distance("a", TestWorld.HOME)).isLessThan(3);

        world.happens(engine, new Effect.CommandsWithdrawn(1, List.of()));
        world.run(60);

        assertThat(distance("a", NORTH.points().get(0))).isLessThan(6);
        assertThat(engine.received("ProxyPathCompleted")).hasSize(1);
    }

    private void runUntilProgress(int visited) {
        for (int tick = 0; tick < 2000 && remembered() == 0; tick++) {
            world.run(0.1);
        }
        assertThat(remembered()).isEqualTo(visited);
    }

    private long remembered() {
        return engine.inputs.stream()
                .filter(input -> input instanceof Input.Remember remember && remember.mission() == 1)
                .count();
    }

    private List<String> messages() {
        return world.operator.messages().messages().stream()
                .map(OperatorMessage::text)
                .toList();
    }

    private double distance(String boat, GeoPoint point) {
        return Geodesy.distanceM(world.hull(boat).position(), point);
    }

    private static TestActivations executePath(Map<String, GeoPath> paths) {
        return new TestActivations("ProxyExecutePath").with("paths", ProxyMaps.toValue(paths));
    }

    private static GeoPath path(double... eastAndNorth) {
        List<GeoPoint> points = new ArrayList<>();
        for (int i = 0; i < eastAndNorth.length; i += 2) {
            points.add(Geodesy.offset(TestWorld.HOME, eastAndNorth[i], eastAndNorth[i + 1]));
        }
        return new GeoPath(points);
    }
}
