package org.sami.boat.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.boat.mavlink.DrivenBoat.LAT;
import static org.sami.boat.mavlink.DrivenBoat.LON;
import static org.sami.boat.mavlink.DrivenBoat.STATION;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.GrantCommand;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.Role;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.mavlink.mission.MissionItem;
import org.sami.mavlink.onboard.OnboardModes;
import org.sami.mavlink.onboard.OrderReply;
import org.sami.mavlink.onboard.StationOrder;

/** What a fence lets the ground station that commands have a boat do. */
class FencedBoatTest {
    private static final String KEEPS = "anna is outside of its fence and keeps its place";
    private static final String AGAIN = "anna is inside of its fence again";

    private final DrivenBoat boat = new DrivenBoat(LostLinkAction.HOLD);

    private static MissionItem point(int number, double north, double east) {
        return MissionItem.waypoint(number, LAT + north, LON + east, 0, 0);
    }

    private static List<MissionItem> circle(double radiusM) {
        return FencePart.circle(FencePart.CIRCLE_INCLUSION, LAT, LON, radiusM);
    }

    private void fence(List<MissionItem> items) {
        boat.fence(items.toArray(new MissionItem[0]));
    }

    private OrderReply goTo(double north) {
        return boat.order(STATION, new StationOrder.GoTo(LAT + north, LON, Optional.empty(), true));
    }

    private void arm(int mode) {
        assertThat(boat.mode(STATION, mode).isAccepted()).isTrue();
        assertThat(boat.arm(STATION).isAccepted()).isTrue();
    }

    private void steerNorth(int seconds) {
        for (int i = 0; i < seconds; i++) {
            boat.order(STATION, new StationOrder.Steer(1, 0));
            boat.pass(1_000, STATION);
        }
    }

    @Test
    void aPlaceOutsideIsRefusedAndTheBoatStaysInItsMode() {
        fence(circle(100));
        arm(OnboardModes.LOITER);

        assertThat(goTo(0.001).words()).isEqualTo("the place is outside of the fence");
        assertThat(boat.vehicle.mode()).isEqualTo(OnboardModes.LOITER);
        assertThat(goTo(0.0005).isAccepted()).isTrue();
        boat.pass(60_000, STATION);
        assertThat(boat.said).isEmpty();
        assertThat(boat.hull.latDeg()).isGreaterThan(LAT + 0.0004);
    }

    @Test
    void aMissionThatLeadsOutIsNotStarted() {
        fence(FencePart.list(circle(500), FencePart.square(FencePart.EXCLUSION, LAT + 0.001, LON, 0.0002)));
        arm(OnboardModes.LOITER);

        boat.mission(point(1, 0.0005, 0), point(2, 0.01, 0));
        assertThat(boat.mode(STATION, OnboardModes.AUTO).words()).isEqualTo("item 2 is outside of the fence");
        boat.mission(point(1, 0.0005, 0), point(2, 0.002, 0));
        assertThat(boat.mode(STATION, OnboardModes.AUTO).words())
                .isEqualTo("the way to item 2 leads outside of the fence");
        assertThat(boat.server.mode()).isEqualTo(BoatMode.HOLD);

        boat.mission(point(1, 0.0005, 0), point(2, 0.001, 0.0005), point(3, 0.002, 0));
        assertThat(boat.mode(STATION, OnboardModes.AUTO).isAccepted()).isTrue();
        assertThat(boat.order(STATION, new StationOrder.GoOnAt(3)).words())
                .isEqualTo("the way to item 3 leads outside of the fence");
        assertThat(boat.mission.progress().item()).isEqualTo(1);
        boat.pass(400_000, STATION);
        assertThat(boat.mission.progress().isDone()).isTrue();
        assertThat(boat.said).isEmpty();
    }

    @Test
    void aBoatThatIsDrivenOutKeepsItsPlaceAndComesBackByAnOrder() {
        fence(circle(20));
        arm(OnboardModes.MANUAL);
        steerNorth(20);

        assertThat(boat.said).containsExactly(KEEPS);
        assertThat(boat.server.mode()).isEqualTo(BoatMode.HOLD);
        assertThat(boat.vehicle.mode()).isEqualTo(OnboardModes.LOITER);
        assertThat(boat.hull.latDeg()).isBetween(LAT + 0.00017, LAT + 0.00022); // 19 to 24 m
        assertThat(boat.mode(STATION, OnboardModes.MANUAL).words())
                .isEqualTo("anna is outside of its fence: send it to a place inside, or remove the fence");
        assertThat(goTo(0.0003).words()).isEqualTo("the place is outside of the fence");
        assertThat(boat.fence.state().breaches()).isEqualTo(1);

        assertThat(goTo(0).isAccepted()).isTrue();
        boat.pass(40_000, STATION);
        assertThat(boat.said).containsExactly(KEEPS, AGAIN);
        assertThat(boat.fence.state().isBreached()).isFalse();
        assertThat(boat.mode(STATION, OnboardModes.MANUAL).isAccepted()).isTrue();
        steerNorth(1);
        assertThat(boat.server.mode()).isEqualTo(BoatMode.TELEOPERATION);
    }

    @Test
    void aFenceThatComesOnTheWayStopsABoatThatWouldLeaveIt() {
        arm(OnboardModes.LOITER);
        assertThat(goTo(0.002).isAccepted()).isTrue();
        boat.pass(3_000, STATION);
        assertThat(boat.server.mode()).isEqualTo(BoatMode.PATH);

        fence(circle(100));
        assertThat(boat.said)
                .containsExactly("the fence is another, and the place is outside of the fence: anna keeps its place");
        assertThat(boat.server.mode()).isEqualTo(BoatMode.HOLD);
        assertThat(boat.fence.state().isBreached()).isFalse();
    }

    @Test
    void aFenceElsewhereHoldsTheBoatUntilItIsRemoved() {
        arm(OnboardModes.LOITER);
        assertThat(goTo(0.002).isAccepted()).isTrue();
        fence(FencePart.circle(FencePart.CIRCLE_INCLUSION, LAT + 0.002, LON, 50));
        boat.pass(1_000, STATION);
        assertThat(boat.said).containsExactly("home is outside of the fence: anna is not sent home", KEEPS);
        assertThat(boat.fenceReports).isEqualTo(1);
        assertThat(boat.mode(STATION, OnboardModes.RETURN).words()).isEqualTo("home is outside of the fence");

        boat.said.clear();
        fence(List.of());
        assertThat(boat.said).containsExactly("anna has no fence in force now");
        assertThat(boat.fenceReports).isEqualTo(2);
        assertThat(boat.mode(STATION, OnboardModes.RETURN).isAccepted()).isTrue();
    }

    @Test
    void motorsThatAreOffStayOffOutside() {
        arm(OnboardModes.HOLD);
        fence(FencePart.circle(FencePart.CIRCLE_EXCLUSION, LAT, LON, 50));
        boat.pass(1_000, STATION);

        assertThat(boat.said).contains("anna is outside of its fence").doesNotContain(KEEPS);
        assertThat(boat.server.mode()).isEqualTo(BoatMode.STOPPED);
        assertThat(boat.mode(STATION, OnboardModes.LOITER).isAccepted()).isTrue();
        assertThat(goTo(0.001).isAccepted()).isTrue(); // the way out of the excluded circle
    }

    @Test
    void aBaseIsNotBoundAndTheFenceCountsOnceItHasHandedOver() {
        fence(circle(20));
        DrivenBoat.Base base = boat.base(Role.COMMANDER);
        base.send(id -> new UploadWaypoints(id, "l1", List.of(new Waypoint(LAT + 0.01, LON, 2))));
        base.send(id -> new StartWaypoints(id, "l1", 0));
        boat.pass(30_000, STATION);
        assertThat(boat.hull.latDeg()).isGreaterThan(LAT + 0.0003);
        assertThat(boat.server.mode()).isEqualTo(BoatMode.PATH);
        assertThat(boat.said).isEmpty();
        assertThat(boat.fence.state().isHeld()).isTrue();
        assertThat(boat.fence.state().isInForce()).isFalse();

        base.send(id -> new GrantCommand(id, BoatClient.NAME));
        boat.pass(1_000, STATION);
        assertThat(boat.said).containsExactly(KEEPS);
        assertThat(boat.server.mode()).isEqualTo(BoatMode.HOLD);
    }
}
