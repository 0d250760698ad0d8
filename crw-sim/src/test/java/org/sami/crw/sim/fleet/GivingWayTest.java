package org.sami.crw.sim.fleet;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.sim.hull.Conditions;
import org.sami.crw.sim.hull.Flow;
import org.sami.crw.sim.hull.HullConfig;
import org.sami.spn.protocol.Priority;

/** How two or three boats give way to one another in calm water: measured on where their hulls truly are. */
class GivingWayTest {
    private static final double APART_M = 3;
    private static final FleetConfig ENDURING =
            FleetConfig.DEFAULT.withHull(HullConfig.DEFAULT.withBatteryPercentPerM(0));

    private SimulatedTestWorld world;
    private double leastM;

    /** Boats lie 5 m apart, boat1 at the origin, the others east of it. */
    private void launch(int boats) {
        world = new SimulatedTestWorld(boats, 1, ENDURING);
        world.run(2);
        leastM = Double.MAX_VALUE;
    }

    private void drive(String boat, double... eastNorth) {
        world.fleet
                .boat(boat)
                .orElseThrow()
                .proxy()
                .commands()
                .submit(FollowPath.of(name(boat), 1, 10, world.points(eastNorth), Priority.MEDIUM));
    }

    private static String name(String boat) {
        return "way of " + boat;
    }

    /** Lets time pass until these boats have arrived; gives how long it took, in seconds, or the limit. */
    private double watch(double limitS, String... boats) {
        double seconds = 0;
        for (; seconds < limitS && !List.of(boats).stream().allMatch(this::hasArrived); seconds += 0.1) {
            world.run(0.1);
            List<SimulatedBoat> all = world.fleet.boats();
            for (int i = 0; i < all.size(); i++) {
                for (int j = i + 1; j < all.size(); j++) {
                    leastM = Math.min(leastM, distanceM(all.get(i), all.get(j)));
                }
            }
        }
        return seconds;
    }

    private boolean hasArrived(String boat) {
        return world.recorders.get(boat).lines.contains("completed " + name(boat));
    }

    private static double distanceM(SimulatedBoat one, SimulatedBoat other) {
        return Math.hypot(
                one.hull().eastM() - other.hull().eastM(),
                one.hull().northM() - other.hull().northM());
    }

    private void begin(String boat, double eastM, double northM) {
        drive(boat, eastM, northM);
        watch(120, boat);
        world.recorders.get(boat).lines.clear();
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.5, -0.5, 2})
    void boatsThatMeetHeadOnPassEachOther(double besideM) {
        launch(2);
        begin("boat2", besideM, 60);

        drive("boat1", 0, 60);
        drive("boat2", besideM, 0);
        double seconds = watch(120, "boat1", "boat2");

        assertThat(leastM).isGreaterThanOrEqualTo(APART_M);
        assertThat(seconds).isLessThan(65); // alone each takes 43 s
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 3, -3, 6})
    void boatsWhoseWaysCrossKeepApart(double laterM) {
        launch(2);
        begin("boat2", 30 + laterM, 30);

        drive("boat1", 0, 60);
        drive("boat2", -30, 30);
        double seconds = watch(120, "boat1", "boat2");

        assertThat(leastM).isGreaterThanOrEqualTo(APART_M);
        assertThat(seconds).isLessThan(65);
    }

    @Test
    void whoHasTheRightOfWayIsNotHeldUp() {
        launch(2);
        begin("boat2", 30, 30);

        drive("boat1", 0, 60);
        drive("boat2", -30, 30);
        double seconds = watch(120, "boat1");

        assertThat(seconds).isLessThan(45);
        assertThat(leastM).isGreaterThanOrEqualTo(APART_M);
    }

    @ParameterizedTest
    @CsvSource({"boat1, boat2", "boat2, boat1"})
    void fastBoatOvertakesASlowOne(String fast, String slow) {
        launch(2);
        begin(slow, 0, 15);
        begin(fast, 0, 0);

        world.fleet.boat(slow).orElseThrow().proxy().settings().setVelocityMultiplier(0.3);
        drive(slow, 0, 60);
        drive(fast, 0, 90);
        double seconds = watch(200, fast);

        assertThat(leastM).isGreaterThanOrEqualTo(APART_M);
        assertThat(seconds).isLessThan(95); // alone it takes 63 s, and behind the other 120 s
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 1, -1})
    void boatThatLiesOnTheLineIsPassed(double besideM) {
        launch(2);
        begin("boat2", besideM, 30);

        drive("boat1", 0, 60);
        double seconds = watch(120, "boat1");

        assertThat(leastM).isGreaterThanOrEqualTo(APART_M);
        assertThat(seconds).isLessThan(55);
        assertThat(world.hull().eastM()).isCloseTo(0, org.assertj.core.data.Offset.offset(1.0));
    }

    /** Next to the line by so little that a boat which turns aside late stands before the other one. */
    @ParameterizedTest
    @ValueSource(doubles = {-2.5, -2, -1.5, -1, -0.5, 0, 0.5, 1, 1.5, 2, 2.5})
    void stoppedBoatIsPassedHoweverNearTheLineItLies(double besideM) {
        launch(2);
        begin("boat2", -38 + besideM, 37 + besideM);
        world.fleet.boat("boat2").orElseThrow().proxy().abort("for a test");

        drive("boat1", -57, 55);
        double seconds = watch(180, "boat1");

        assertThat(leastM).isGreaterThanOrEqualTo(APART_M);
        assertThat(seconds).isLessThan(110);
    }

    @Test
    void boatsThatGoToOnePointBothComeThere() {
        launch(3);

        drive("boat1", 5, 40);
        drive("boat2", 5, 40);
        drive("boat3", 5, 40);
        double seconds = watch(200, "boat1", "boat2", "boat3");

        assertThat(leastM).isGreaterThanOrEqualTo(APART_M);
        assertThat(seconds).isLessThan(120);
    }

    @Test
    void boatThatKeepsItsStationMakesRoomWithinItsCircle() {
        launch(2);
        begin("boat2", 0, 30);
        SimulatedBoat keeper = world.fleet.boat("boat2").orElseThrow();
        double eastM = keeper.hull().eastM();
        double northM = keeper.hull().northM();

        drive("boat1", 0, 30, 0, 60);
        double farthestM = 0;
        for (int i = 0; i < 120 && !hasArrived("boat1"); i++) {
            watch(0.5, "boat1");
            farthestM = Math.max(farthestM, awayM(keeper, eastM, northM));
        }

        assertThat(hasArrived("boat1")).isTrue();
        assertThat(leastM).isGreaterThanOrEqualTo(APART_M);
        assertThat(farthestM).isBetween(3.0, 5.5);
        assertThat(awayM(keeper, eastM, northM)).as("it has come back").isLessThan(2.5);
    }

    private static double awayM(SimulatedBoat boat, double eastM, double northM) {
        return Math.hypot(boat.hull().eastM() - eastM, boat.hull().northM() - northM);
    }

    /** A boat that is alone drifts up to 5 m before it drives back. */
    @Test
    void boatsThatDriftKeepTheirStationsCloselyWhereOthersAreNear() {
        Conditions drifting = new Conditions(0, 0, Flow.parse("0.25@90"), Flow.NONE, List.of());
        world = new SimulatedTestWorld(2, 1, ENDURING.withConditions(drifting));
        world.run(2);
        drive("boat1", 0, 30);
        drive("boat2", 15, 30);
        watch(120, "boat1", "boat2");

        leastM = Double.MAX_VALUE;
        double farthestM = 0;
        SimulatedBoat one = world.fleet.boats().get(0);
        SimulatedBoat other = world.fleet.boats().get(1);
        for (int i = 0; i < 120; i++) {
            world.run(0.5);
            leastM = Math.min(leastM, distanceM(one, other));
            farthestM = Math.max(farthestM, Math.max(awayM(one, 0, 30), awayM(other, 15, 30)));
        }

        assertThat(farthestM).isLessThan(2.5);
        assertThat(leastM).isGreaterThan(11);
    }

    @Test
    void ofTwoBoatsWithOneStationTheOtherLiesStillBesideIt() {
        launch(3);
        drive("boat3", 15, 40, 15, 80, 15, 40, 15, 80, 15, 40, 15, 80, 15, 40, 15, 80, 15, 40, 15, 80, 15, 40);
        drive("boat1", 0, 60);
        drive("boat2", 0, 60);
        watch(180, "boat1", "boat2");
        world.run(30);
        double drivenM = drivenM("boat1") + drivenM("boat2");

        world.run(120); // while they are told of the third one

        assertThat(hasArrived("boat3")).isFalse();
        assertThat(drivenM("boat1") + drivenM("boat2") - drivenM)
                .as("metres of both")
                .isLessThan(10);
        assertThat(leastM).isGreaterThanOrEqualTo(APART_M);
    }

    private double drivenM(String boat) {
        return world.fleet.boat(boat).orElseThrow().distanceM();
    }

    @Test
    void boatWhosePointIsTakenByOneThatIsStoppedWaitsApart() {
        launch(2);
        begin("boat2", 0, 30);
        world.fleet.boat("boat2").orElseThrow().proxy().abort("for a test");

        drive("boat1", 0, 30);
        watch(90, "boat1");

        assertThat(hasArrived("boat1")).isFalse();
        assertThat(leastM).isGreaterThanOrEqualTo(APART_M);
        assertThat(distanceM(world.fleet.boats().get(0), world.fleet.boats().get(1)))
                .isLessThan(10);
    }

    @Test
    void boatsLeaveTheQuayWithWaysThatCross() {
        launch(3);

        drive("boat1", 40, 20);
        drive("boat2", 5, 40);
        drive("boat3", -40, 20);
        double seconds = watch(150, "boat1", "boat2", "boat3");

        assertThat(leastM).isGreaterThanOrEqualTo(APART_M);
        assertThat(seconds).isLessThan(70);
    }

    /** Nobody tells a boat whose link is lost where others go: it drives on as if nobody were there, and they keep clear of it. */
    @Test
    void boatWithoutALinkIsKeptClearOfAsLongAsItWasSeen() {
        launch(2);
        begin("boat2", 0, 60);
        drive("boat1", 0, 60);
        drive("boat2", 0, 0);
        world.run(15);
        world.fleet.boat("boat2").orElseThrow().toBoat().setCut(true); // it holds after 3.5 s, and tells where it is

        watch(60, "boat1");

        assertThat(hasArrived("boat1")).isTrue();
        assertThat(leastM).isGreaterThanOrEqualTo(APART_M);
    }

    @Test
    void boatsThatLieStillAreToldNothing() {
        launch(5);
        long before = world.fleet.boats().get(2).toBoat().delivered();

        world.run(30);

        assertThat(world.fleet.boats().get(2).toBoat().delivered() - before).isBetween(28L, 32L); // heartbeats alone
    }
}
