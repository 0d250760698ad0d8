package org.sami.uav.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.crw.area.OperatingArea;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.water.Water;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.Value;

/** Follow, of copters behind copter1, which takes off with them. */
class FollowHandlerTest {
    private static final GeoPoint BASE = GeoPoint.of(45.7, 10.72);
    private static final GeoArea ROCKS = square(Geodesy.offset(BASE, 0, 100), 30);

    private FlightHandlerHarness harness = new FlightHandlerHarness(0);

    private static GeoArea square(GeoPoint middle, double halfM) {
        return new GeoArea(
                List.of(
                        Geodesy.offset(middle, -halfM, -halfM),
                        Geodesy.offset(middle, halfM, -halfM),
                        Geodesy.offset(middle, halfM, halfM),
                        Geodesy.offset(middle, -halfM, halfM)),
                List.of());
    }

    private static GeoPoint north(double metres) {
        return Flights.at(Geodesy.offset(BASE, 0, metres), 20);
    }

    private void begin(int copters) {
        harness = new FlightHandlerHarness(copters);
        harness.pass(2);
    }

    private void follow(Map<String, Value> also, String... copters) {
        FollowHandler follow = new FollowHandler(
                harness.fleet.proxies(),
                harness.flights,
                harness.motion,
                message -> harness.messages.add(message.text()),
                Runnable::run);
        harness.listen(follow);
        Map<String, Value> values = new HashMap<>(also);
        values.put("robot", new ProxyValue("copter1"));
        harness.activate(follow, values, copters);
    }

    private void leadTo(GeoPoint point) {
        TaskFlights tasks = harness.taskFlights();
        harness.activate(new FlyToHandler(harness.flights, tasks), Map.of("location", point), "copter1");
    }

    private GeoPoint at(String copter) {
        return harness.flights.position(copter).orElseThrow();
    }

    private double apartM() {
        return Geodesy.distanceM(at("copter1"), at("copter2"));
    }

    /** Has time pass in which the follower is in the water only. */
    private void passIn(Water water, int seconds) {
        for (int i = 0; i < seconds; i++) {
            harness.pass(1);
            assertThat(water.depthM(at("copter2"))).as("at %s s", i).isZero();
        }
    }

    private BoatCommand command(String copter) {
        return harness.proxy(copter).commands().current().orElseThrow();
    }

    @Test
    void followersFlyAtAltitudesOfTheirOwn() {
        begin(3);
        follow(Map.of(), "copter2", "copter3");

        assertThat(List.of("copter2", "copter3"))
                .extracting(name -> ((FollowPath) command(name)).points().get(0).altM())
                .containsExactly(34.0, 38.0);
    }

    @Test
    void aircraftThatIsFollowedIsLeftOutAndTheOperatorIsTold() {
        begin(2);
        follow(Map.of(), "copter1", "copter2");

        assertThat(harness.proxy("copter1").commands().current()).isEmpty();
        assertThat(harness.proxy("copter2").commands().current()).isPresent();
        assertThat(harness.messages).containsExactly("copter1 is the one that is followed, and follows nobody");
    }

    @Test
    void refusedFollowIsSaidOnce() {
        begin(2);
        follow(Map.of("altitude", new RealValue(200)), "copter2");
        leadTo(north(60));
        harness.pass(60);

        assertThat(harness.messages).singleElement().asString().contains("above the ceiling");
    }

    @Test
    void followerStaysOutOfANoGoAreaAndGoesOnBehindIt() {
        begin(2);
        Water water = Water.of(BASE, List.of(ROCKS), Optional.empty());
        follow(Map.of("avoid", new ListValue(List.of(ROCKS))), "copter2");
        leadTo(north(110));
        passIn(water, 90);

        assertThat(harness.messages).singleElement().asString().contains("stays where it is", "no-go area");
        assertThat(harness.altM("copter2")).isGreaterThan(20);
        assertThat(apartM()).isGreaterThan(30);

        leadTo(north(200));
        passIn(water, 90);

        assertThat(harness.messages).hasSize(2);
        assertThat(harness.messages.get(1)).contains("follows copter1 again");
        assertThat(apartM()).isLessThan(25);
    }

    @Test
    void followerDoesNotLeaveTheFence() {
        begin(2);
        GeoArea fence = square(BASE, 60);
        harness.memory.put(OperatingArea.MEMORY, fence);
        Water water = Water.of(BASE, List.of(), Optional.of(fence));
        follow(Map.of(), "copter2");
        leadTo(north(150));
        passIn(water, 90);

        assertThat(harness.messages).singleElement().asString().contains("leave the area in which it is to stay");

        leadTo(north(20));
        passIn(water, 90);

        assertThat(apartM()).isLessThan(25);
    }

    @Test
    void followerThatWasStoppedDoesNotFlyOffByItself() {
        begin(2);
        follow(Map.of(), "copter2");
        leadTo(north(150));
        harness.pass(12);
        harness.proxy("copter2").abort("the operator stopped the fleet");
        harness.pass(5);
        GeoPoint stopped = at("copter2");
        harness.pass(60);

        assertThat(Geodesy.distanceM(stopped, at("copter2"))).isLessThan(3);
        assertThat(harness.messages).hasSize(2);
        assertThat(harness.messages.get(0)).contains("the operator stopped the fleet");
        assertThat(harness.messages.get(1)).contains("does not follow copter1 any longer");
    }

    @Test
    void baseThatGoesOnUsesNoCommandIdOfTheOneBefore() {
        begin(2);
        follow(Map.of(), "copter2");
        String before = command("copter2").commandId();
        begin(2);
        harness.isRedelivered = true;
        follow(Map.of(), "copter2");

        assertThat(command("copter2").commandId()).isNotEqualTo(before);
    }
}
