package org.sami.uav.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sami.crw.area.OperatingArea;
import org.sami.crw.handler.activation.Addressee;
import org.sami.crw.handler.motion.AbortHandler;
import org.sami.crw.handler.motion.AbortScope;
import org.sami.crw.handler.motion.Aborts;
import org.sami.crw.handler.motion.EmergencyAbortHandler;
import org.sami.crw.handler.motion.LaterMoves;
import org.sami.crw.handler.motion.ProxyAbortMissionHandler;
import org.sami.crw.service.Geodesy;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;

/** Aborts reach flights that no aircraft has as a command yet. */
class FlightAbortsTest {
    private static final GeoPoint BASE = GeoPoint.of(45.7, 10.72);
    private static final GeoPoint POST = new GeoPoint(45.7005, 10.7205, 20);
    private static final GeoPoint FAR = new GeoPoint(45.71, 10.72, 20);
    private static final Map<String, Value> UP = Map.of("altitude", new RealValue(20));

    private final FlightHandlerHarness harness = new FlightHandlerHarness(2);

    private Aborts aborts(LaterMoves later) {
        return new Aborts(harness.fleet.proxies(), harness.motion, List.of(later));
    }

    private void stop(LaterMoves later, String copter) {
        harness.activate(new EmergencyAbortHandler(aborts(later)), Map.of(), copter);
    }

    private void takeOff() {
        harness.activate(VerticalHandler.climbing(harness.flights, UavEvents.AIRBORNE), UP, "copter1");
    }

    @Test
    void takeOffThatWaitsForThePositionFailsAtAnEmergencyAbort() {
        takeOff();
        stop(harness.flights, "copter1");
        harness.pass(60);

        assertThat(harness.answered()).containsExactly(UavEvents.CANNOT_FLY);
        assertThat(harness.altM("copter1")).isZero();
    }

    @Test
    void takeOffThatWaitsForThePositionIsTakenBackByItsMissionWithoutAnAnswer() {
        takeOff();
        harness.activate(new ProxyAbortMissionHandler(aborts(harness.flights)), Map.of(), "copter1");
        harness.pass(60);

        assertThat(harness.answers).isEmpty();
        assertThat(harness.altM("copter1")).isZero();
    }

    @Test
    void abortOfAnotherAircraftLeavesATakeOffThatWaits() {
        takeOff();
        stop(harness.flights, "copter2");
        harness.pass(60);

        assertThat(harness.altM("copter1")).isGreaterThan(19);
    }

    @Test
    void tasksThatAnAircraftIsToFlyToLaterFailAtAnEmergencyAbort() {
        harness.pass(2);
        TaskFlights flights = harness.taskFlights();
        harness.listen(flights);
        List<TaskId> tasks = List.of(new TaskId(1, "T1"), new TaskId(1, "T2"));
        harness.activate(
                (activation, context) -> {
                    for (TaskId task : tasks) {
                        List<GeoPoint> to = List.of(task.name().equals("T1") ? FAR : POST);
                        Addressee one = new Addressee("copter1", false, List.of(task));
                        flights.add(activation, context, new Flights.Flight(one, to, Flights.SPEED_MPS));
                    }
                    flights.startWaiting();
                },
                Map.of(),
                tasks.stream().<Token>map(Token.Task::new).toList());
        harness.pass(10);

        stop(flights, "copter1");
        flights.startWaiting();

        assertThat(harness.answered()).containsExactly(UavEvents.CANNOT_FLY, UavEvents.CANNOT_FLY);
        assertThat(harness.proxy("copter1").commands().current()).isEmpty();
    }

    /** It hovers at the fence, and its leader comes back. */
    @Test
    void followerThatWaitsDoesNotFlyOffAfterAnEmergencyAbort() {
        harness.pass(2);
        harness.memory.put(OperatingArea.MEMORY, square(60));
        FollowHandler follow = secondFollowsFirst();
        leadTo(150);
        harness.pass(90);
        assertThat(harness.messages).singleElement().asString().contains("stays where it is");

        stop(follow, "copter2");
        harness.pass(30);
        GeoPoint stopped = harness.flights.position("copter2").orElseThrow();
        leadTo(20);
        harness.pass(60);

        assertThat(Geodesy.distanceM(
                        stopped, harness.flights.position("copter2").orElseThrow()))
                .isLessThan(5);
        assertThat(harness.messages.get(1)).contains("does not follow copter1 any longer");
    }

    /** It has caught up, and has no command until its leader moves on. */
    @Test
    void abortOfFutureMissionsLeavesAFollowerThatHasCaughtUp() {
        harness.pass(2);
        FollowHandler follow = secondFollowsFirst();
        leadTo(20);
        harness.pass(60);
        assertThat(harness.proxy("copter2").commands().current()).isEmpty();
        GeoPoint before = harness.flights.position("copter2").orElseThrow();

        AbortHandler future = new AbortHandler(AbortScope.FUTURE, harness.fleet.proxies(), aborts(follow));
        harness.activate(future, Map.of(), "copter2");
        leadTo(120);
        harness.pass(60);

        assertThat(Geodesy.distanceM(before, harness.flights.position("copter2").orElseThrow()))
                .isGreaterThan(50);
        assertThat(harness.messages).isEmpty();
    }

    private FollowHandler secondFollowsFirst() {
        FollowHandler follow = new FollowHandler(
                harness.fleet.proxies(),
                harness.flights,
                harness.motion,
                message -> harness.messages.add(message.text()),
                Runnable::run);
        harness.listen(follow);
        harness.activate(follow, new HashMap<>(Map.of("robot", new ProxyValue("copter1"))), "copter2");
        return follow;
    }

    private void leadTo(double northM) {
        TaskFlights tasks = harness.taskFlights();
        GeoPoint to = Flights.at(Geodesy.offset(BASE, 0, northM), 20);
        harness.activate(new FlyToHandler(harness.flights, tasks), Map.of("location", to), "copter1");
    }

    private static GeoArea square(double halfM) {
        return new GeoArea(
                List.of(
                        Geodesy.offset(BASE, -halfM, -halfM),
                        Geodesy.offset(BASE, halfM, -halfM),
                        Geodesy.offset(BASE, halfM, halfM),
                        Geodesy.offset(BASE, -halfM, halfM)),
                List.of());
    }
}
