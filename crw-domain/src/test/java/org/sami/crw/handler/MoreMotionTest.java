package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;

import java.util.List;
import java.util.Map;
import org.assertj.core.groups.Tuple;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.sami.crw.event.ProxyMaps;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.command.UploadCount;
import org.sami.crw.service.Geodesy;
import org.sami.spn.engine.MissionView;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.MissionStatus;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.Value;

/** Blocking ways, lists of locations and waypoints that are sent again, on a real boat server with a hull. */
class MoreMotionTest {
    private static final GeoPoint NEAR = at(30, 0);
    private static final GeoPoint FAR = at(0, 60);

    private final ScriptedEngine engine = new ScriptedEngine(TestWorld.VOCABULARY);
    private final TestWorld world = new TestWorld(engine);

    @BeforeEach
    void twoBoats() {
        engine.awaited.addAll(List.of("ProxyPathCompleted", "ProxyPathFailed", "BlockMovementDone"));
        world.addBoat("a", 0, 0);
        world.addBoat("b", 5, 0);
        world.run(1);
    }

    @Test
    void aPointAndBlockKeepsTheBoatThereUntilTheMissionEnds() {
        missionRuns(1);
        happens(gotoPointAndBlock(Map.of("a", NEAR)).of("a"));
        world.run(60);
        assertThat(completed()).containsExactly(tuple(7L, List.of("a")));
        happens(gotoFar(8));
        world.run(60);
        assertThat(distance("a", NEAR)).isLessThan(6);

        world.happens(engine, new Effect.CommandsWithdrawn(1, List.of()));
        world.run(90);

        assertThat(distance("a", FAR)).isLessThan(6);
        assertThat(completed()).containsExactly(tuple(7L, List.of("a")), tuple(8L, List.of("a")));
    }

    /** Thesis 6.3.3: the avoided boat must not drive back to its area, and again out of it. */
    @Test
    void aCriticalBlockHoldsBackThePathThatItInterruptedAndThatReturnsAfterIt() {
        missionRuns(2);
        happens(gotoFar(8).mission(1));
        world.run(3);
        happens(gotoPointAndBlock(Map.of("a", NEAR))
                .mission(2)
                .priority(Priority.CRITICAL)
                .of("a"));
        world.run(120);
        assertThat(distance("a", NEAR)).isLessThan(6);
        assertThat(completed()).containsExactly(tuple(7L, List.of("a")));

        world.happens(engine, new Effect.CommandsWithdrawn(2, List.of()));
        world.run(90);

        assertThat(completed()).endsWith(tuple(8L, List.of("a")));
        assertThat(engine.received("ProxyPathFailed")).isEmpty();
    }

    @Test
    void aPathAndBlockOfWhichNothingIsLeftStillKeepsTheBoat() {
        missionRuns(1);
        happens(pathAndBlock(new GeoPath(List.of(NEAR))).of("a"));
        world.run(60);
        happens(pathAndBlock(new GeoPath(List.of(NEAR))).id(9).of("a"));
        happens(gotoFar(8));
        world.run(60);

        assertThat(completed()).containsExactly(tuple(7L, List.of("a")), tuple(9L, List.of("a")));
        assertThat(distance("a", NEAR)).isLessThan(6);
    }

    @Test
    void aMissionThatHasEndedKeepsNoBoat() {
        happens(gotoPointAndBlock(Map.of("a", NEAR)).of("a"));
        world.run(40);
        happens(gotoFar(8));
        world.run(90);

        assertThat(distance("a", FAR)).isLessThan(6);
    }

    @Test
    void aBlockAnswersWhenTheBoatHasStopped() {
        missionRuns(1);
        happens(gotoFar(8).mission(1));
        world.run(5);
        assertThat(world.hull("a").isAtRest()).isFalse();

        world.cutLinks(true);
        happens(new TestActivations("BlockMovement").of("a", "b"));
        assertThat(engine.received("BlockMovementDone")).isEmpty();
        world.cutLinks(false);
        world.run(3);

        assertThat(engine.received("BlockMovementDone"))
                .extracting(Occurrence::proxies, Occurrence::activation)
                .containsExactlyInAnyOrder(tuple(List.of("a"), 7L), tuple(List.of("b"), 7L));
        assertThat(world.hull("a").isAtRest()).isTrue();
    }

    @Test
    void whatNobodyWaitsForIsNotAnswered() {
        missionRuns(1);
        engine.awaited.clear();

        happens(new TestActivations("BlockMovement").of("a"));
        happens(new TestActivations("ProxyResendWaypoints").id(8).of("b"));
        world.run(1);

        assertThat(engine.received("BlockMovementDone")).isEmpty();
        assertThat(engine.received("ProxyPathCompleted")).isEmpty();
    }

    @Test
    void aListIsGoneThroughOneLocationAtEachEntry() {
        Value lists = ProxyMaps.toValue(Map.of("a", new ListValue(List.of(NEAR, FAR))));
        for (long id = 1; id <= 3; id++) {
            happens(new TestActivations("ProxyGotoLocationList")
                    .id(id)
                    .with("locations", lists)
                    .of("a", "b"));
            world.run(90);
            if (id == 1) {
                assertThat(distance("a", NEAR)).isLessThan(6);
            }
        }

        assertThat(distance("a", FAR)).isLessThan(6);
        assertThat(completed()).containsExactly(tuple(1L, List.of("a")), tuple(2L, List.of("a")));
        assertThat(engine.received("ProxyListCompleted"))
                .extracting(Occurrence::activation, Occurrence::proxies)
                .containsExactly(
                        tuple(1L, List.of("b")),
                        tuple(2L, List.of("b")),
                        tuple(3L, List.of("a")),
                        tuple(3L, List.of("b")));
    }

    @Test
    void aLocationOfAListThatWasNotReachedIsTheNextOneAgain() {
        Value lists = ProxyMaps.toValue(Map.of("a", new ListValue(List.of(NEAR, FAR))));
        happens(new TestActivations("ProxyGotoLocationList")
                .id(1)
                .with("locations", lists)
                .of("a"));
        world.run(3);
        world.happens(engine, new Effect.CommandsWithdrawn(1, List.of("a")));

        happens(new TestActivations("ProxyGotoLocationList")
                .id(2)
                .with("locations", lists)
                .of("a"));
        world.run(90);

        assertThat(distance("a", NEAR)).isLessThan(6);
        assertThat(completed()).containsExactly(tuple(2L, List.of("a")));
    }

    @Test
    void waypointsGoToTheBoatOnceMoreAndBothMissionsHearOfTheirEnd() {
        Activation resend = new TestActivations("ProxyResendWaypoints")
                .id(9)
                .mission(2)
                .of("a")
                .activation();
        engine.open.add(resend);
        happens(gotoFar(8).mission(1));
        world.run(10);
        BoatProxy boat = world.boats.find("a").orElseThrow();
        UploadCount before = boat.commands().uploads();
        String held = boat.commands().heldListId().orElseThrow();

        world.happens(engine, new Effect.Activated(resend));
        world.run(90);

        assertThat(boat.commands().uploads().readBackEqual()).isEqualTo(before.readBackEqual() + 1);
        assertThat(boat.commands().heldListId()).isPresent().get().isNotEqualTo(held);
        assertThat(distance("a", FAR)).isLessThan(6);
        assertThat(engine.received("ProxyPathCompleted"))
                .extracting(Occurrence::mission, Occurrence::activation)
                .containsExactly(tuple(1L, 8L), tuple(2L, 9L));
    }

    @Test
    void aBoatWithoutWaypointsHasNothingLeftOfThem() {
        happens(new TestActivations("ProxyResendWaypoints").of("a", "ghost"));

        assertThat(completed()).containsExactly(tuple(7L, List.of("a")));
        assertThat(engine.received("ProxyPathFailed"))
                .extracting(Occurrence::proxies)
                .containsExactly(List.of("ghost"));
    }

    @Test
    void whoeverHadWaypointsSentAgainHearsThatTheirMissionTookThemBack() {
        Activation resend = new TestActivations("ProxyResendWaypoints")
                .id(9)
                .mission(2)
                .of("a")
                .activation();
        engine.open.add(resend);
        happens(gotoFar(8).mission(1));
        world.run(5);
        world.happens(engine, new Effect.Activated(resend));

        world.happens(engine, new Effect.CommandsWithdrawn(1, List.of()));

        assertThat(engine.received("ProxyPathFailed"))
                .extracting(Occurrence::mission)
                .containsExactly(2L);
    }

    private void missionRuns(long id) {
        engine.missions.put(id, new MissionView(id, 0, id, "plan", "", MissionStatus.RUNNING, Map.of()));
    }

    private void happens(TestActivations asking) {
        world.happens(engine, asking.effect());
    }

    private List<Tuple> completed() {
        return engine.received("ProxyPathCompleted").stream()
                .map(answer -> tuple(answer.activation(), answer.proxies()))
                .toList();
    }

    private static TestActivations gotoPointAndBlock(Map<String, GeoPoint> points) {
        return new TestActivations("ProxyGotoPointAndBlock").with("points", ProxyMaps.toValue(points));
    }

    private static TestActivations pathAndBlock(GeoPath path) {
        return new TestActivations("ProxyExecutePathAndBlock").with("paths", ProxyMaps.toValue(Map.of("a", path)));
    }

    /** Another mission wants boat a far away. */
    private static TestActivations gotoFar(long id) {
        return new TestActivations("ProxyGotoLatLon")
                .id(id)
                .mission(5)
                .with("location", FAR)
                .of("a");
    }

    private double distance(String boat, GeoPoint point) {
        return Geodesy.distanceM(world.hull(boat).position(), point);
    }

    private static GeoPoint at(double eastM, double northM) {
        return Geodesy.offset(TestWorld.HOME, eastM, northM);
    }
}
