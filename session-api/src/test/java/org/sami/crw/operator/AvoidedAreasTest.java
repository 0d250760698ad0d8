package org.sami.crw.operator;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.operator.alarm.Alarm;
import org.sami.crw.operator.alarm.Alarm.Kind;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.operator.boat.BoatSnapshot.Commander;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.explanation.BoatExplanation;
import org.sami.crw.proxy.explanation.BoatExplanation.Cause;
import org.sami.crw.proxy.queue.CommandQueueSnapshot;
import org.sami.crw.proxy.queue.TurnWait;
import org.sami.crw.proxy.status.BoatPose;
import org.sami.crw.proxy.status.LinkState;
import org.sami.crw.service.Geodesy;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.Value;

/** What missions promise to keep out of, and which boats raise an alarm there. */
class AvoidedAreasTest {
    private static final GeoPoint HOME = GeoPoint.of(45.6, 10.68);

    /** A survey that keeps out of two variables' areas, one of them asked, and runs a sub-mission that says nothing of them. */
    private static final String PLANS = """
        {"formatVersion": 1, "id": "p", "name": "P", "domain": "crw", "plans": [
          {"id": "survey", "name": "Survey",
            "variables": [{"name": "@rocks", "type": "list<area>", "initial": []}],
            "places": [{"id": "start", "name": "Start", "start": true},
              {"id": "ways", "outputs": [
                {"id": "safest", "type": "PathRequest", "fields": {"avoid": {"variable": "@rocks"}}},
                {"id": "nearest", "type": "PathRequest", "fields": {"avoid": {"ask": "editable", "default": []}}}]},
              {"id": "legs", "subMissions": [{"id": "s1", "plan": "leg"}]},
              {"id": "end", "end": true}],
            "transitions": [
              {"id": "go"},
              {"id": "over", "inputs": [{"id": "i", "type": "OperatorInterruptReceived", "fields": {"interruptName": "Over"}}]}],
            "inEdges": [
              {"id": "e1", "place": "start", "transition": "go", "requirements": [{"match": "at-least", "n": 1, "kind": "any-proxy"}]},
              {"id": "e2", "place": "start", "transition": "over", "requirements": [{"match": "at-least", "n": 1, "kind": "generic"}]}],
            "outEdges": [
              {"id": "o1", "transition": "go", "place": "legs", "requirements": [{"action": "take", "n": "all", "kind": "any-proxy"}]},
              {"id": "o2", "transition": "over", "place": "end", "requirements": [{"action": "take", "n": "all", "kind": "any-token"}]}]},
          {"id": "leg", "name": "Leg",
            "places": [{"id": "start", "start": true}],
            "transitions": [], "inEdges": [], "outEdges": []}]}
        """;

    private final ModelWorld world = new ModelWorld(PLANS);
    private final OperatorModels models = world.models;
    private int commands;
    private CommandQueueSnapshot queue = CommandQueueSnapshot.EMPTY;

    private static GeoPoint at(double eastM, double northM) {
        return Geodesy.offset(HOME, eastM, northM);
    }

    private static GeoArea square(double westM, double southM, double sideM) {
        return new GeoArea(
                List.of(
                        at(westM, southM),
                        at(westM + sideM, southM),
                        at(westM + sideM, southM + sideM),
                        at(westM, southM + sideM)),
                List.of());
    }

    private static Value list(GeoArea... areas) {
        return new ListValue(List.of(areas));
    }

    @BeforeEach
    void surveyRuns() {
        world.step(
                new Input.ProxyJoined("anna"),
                new Input.StartMission("survey", "survey", Map.of("nearest.avoid", list(square(-100, -100, 50)))));
        world.settle();
        world.step(new Input.SetVariable(1, "@rocks", list(square(100, 0, 50))));
        world.settle();
    }

    private void seeAnna(GeoPoint where) {
        world.nowMillis.addAndGet(1000);
        long now = world.nowMillis.get();
        models.fleet()
                .seen(
                        "anna",
                        Optional.of(new BoatSnapshot(
                                "anna",
                                LinkState.LINKED,
                                OptionalLong.of(now),
                                Optional.of(new BoatPose(where, 0, 1, now)),
                                now,
                                Optional.empty(),
                                Optional.empty(),
                                Commander.THIS_BASE,
                                Optional.empty(),
                                0,
                                0,
                                new BoatExplanation(true, Cause.UNDER_WAY, ""),
                                List.of())));
        world.settle();
    }

    /** A mission sends the boat along a path. */
    private void sent(long mission, GeoPoint... points) {
        FollowPath path = FollowPath.of("c" + ++commands, mission, 1, List.of(points), Priority.MEDIUM);
        queue = new CommandQueueSnapshot(
                Optional.of(new CommandQueueSnapshot.Entry(path, 0, points.length, TurnWait.NOT)),
                List.of(),
                OptionalLong.empty());
        world.events.publish(new FleetEvent.QueueChanged("anna", queue));
        world.settle();
    }

    private Optional<String> alarm(Kind kind) {
        return alarm(models, kind);
    }

    private static Optional<String> alarm(OperatorModels of, Kind kind) {
        return of.alarms().snapshot().stream()
                .filter(alarm -> alarm.kind() == kind && alarm.active())
                .map(Alarm::text)
                .findFirst();
    }

    @Test
    void boatInAnAreaThatItsMissionAvoidsIsAnAlarmUntilItLeaves() {
        sent(1, at(300, 0));
        seeAnna(at(101, 25)); // as GPS wanders
        assertThat(alarm(Kind.FENCE)).isEmpty();

        seeAnna(at(105, 25));
        assertThat(alarm(Kind.FENCE)).contains("anna is in an area that mission 1, Survey is to keep out of");
        seeAnna(at(90, 25));
        assertThat(alarm(Kind.FENCE)).isEmpty();

        seeAnna(at(160, 25));
        assertThat(alarm(Kind.FENCE)).contains("anna went through an area that mission 1, Survey is to keep out of");
    }

    @Test
    void pathThroughAnAvoidedAreaIsAnAlarmBeforeTheBoatIsThere() {
        seeAnna(HOME);
        sent(1, at(50, 60), at(200, 25));
        assertThat(alarm(Kind.FENCE_AHEAD))
                .get()
                .asString()
                .startsWith("Mission 1, Survey sends anna through an area that it is to keep out of, near 45.6");

        sent(1, at(50, 60), at(100, 50), at(200, 60)); // touches a corner
        assertThat(alarm(Kind.FENCE_AHEAD)).isEmpty();
    }

    @Test
    void whatThePlanWasGivenAtTheStartIsAvoidedToo() {
        seeAnna(HOME);
        sent(1, at(-75, -75));

        assertThat(alarm(Kind.FENCE_AHEAD)).isPresent();
    }

    @Test
    void subMissionKeepsOutOfWhatThePlanAroundItAvoids() {
        seeAnna(HOME);
        sent(2, at(200, 25));

        assertThat(alarm(Kind.FENCE_AHEAD)).get().asString().startsWith("Mission 2, Leg sends anna through an area");
    }

    @Test
    void boatThatAnotherMissionSendsMayGoThere() {
        sent(7, at(200, 25));
        seeAnna(at(125, 25));

        assertThat(alarm(Kind.FENCE)).isEmpty();
        assertThat(alarm(Kind.FENCE_AHEAD)).isEmpty();
    }

    @Test
    void areaThatIsTakenBackIsFreeAtOnceAndEndsWithTheMission() {
        seeAnna(at(125, 25));
        sent(1, at(200, 25));
        assertThat(alarm(Kind.FENCE)).isPresent();

        world.step(new Input.SetVariable(1, "@rocks", list()));
        world.settle();
        assertThat(alarm(Kind.FENCE)).isEmpty();

        world.step(new Input.SetVariable(1, "@rocks", list(square(100, 0, 50))));
        world.settle();
        assertThat(alarm(Kind.FENCE)).isPresent();
        world.step(new Input.AbortMission(1));
        world.settle();
        assertThat(alarm(Kind.FENCE)).isEmpty();
    }

    @Test
    void sessionThatGoesOnKnowsWhatItsMissionsAvoid() {
        OperatorModels later = new OperatorModels(Runnable::run, () -> 0);
        world.host.ask(view -> {
            later.restore(view, 7000);
            return null;
        });
        later.fleet().seen("anna", models.fleet().boat("anna"));
        sent(1, at(200, 25));
        seeAnna(at(125, 25));
        later.fleetListener(world.boats).accept(new FleetEvent.QueueChanged("anna", queue));
        later.fleet().seen("anna", models.fleet().boat("anna"));

        assertThat(alarm(later, Kind.FENCE)).contains("anna is in an area that mission 1, Survey is to keep out of");
    }
}
