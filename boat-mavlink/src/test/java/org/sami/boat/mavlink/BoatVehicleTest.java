package org.sami.boat.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.boat.mavlink.DrivenBoat.LAT;
import static org.sami.boat.mavlink.DrivenBoat.LON;
import static org.sami.boat.mavlink.DrivenBoat.STATION;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.Progress;
import org.sami.mavlink.mission.MissionItem;
import org.sami.mavlink.onboard.OnboardModes;
import org.sami.mavlink.onboard.OrderReply;
import org.sami.mavlink.onboard.StationOrder;

/** What a boat does on the orders of the ground station that commands it. */
class BoatVehicleTest {
    private static final int CHANGE_SPEED = 178;

    private final DrivenBoat boat = new DrivenBoat(LostLinkAction.HOLD);

    private static MissionItem point(int number, double north) {
        return MissionItem.waypoint(number, LAT + north, LON, 0, 0);
    }

    private OrderReply goTo(double north) {
        return boat.order(STATION, new StationOrder.GoTo(LAT + north, LON, Optional.empty(), true));
    }

    private void arm() {
        assertThat(boat.mode(STATION, OnboardModes.LOITER).isAccepted()).isTrue();
        assertThat(boat.arm(STATION).isAccepted()).isTrue();
    }

    @Test
    void aBoatThatLostItsPositionShowsNoneAndGoesNowhere() {
        arm();
        assertThat(boat.client.telemetry(boat.nowMs)).isPresent();

        boat.hull.loseFix();
        boat.pass(2_500, STATION);
        assertThat(boat.client.telemetry(boat.nowMs)).isEmpty();
        assertThat(boat.client.batteryPercent()).contains(90.0);
        assertThat(goTo(0.001).words()).isEqualTo("anna does not know where it is");
        boat.mission(point(1, 0.001));
        assertThat(boat.mode(STATION, OnboardModes.AUTO).words()).isEqualTo("anna does not know where it is");
        assertThat(boat.vehicle.mode()).isEqualTo(OnboardModes.LOITER);
    }

    @Test
    void aMissionWithAPlaceTooFarAwayIsNotStartedAndTheBoatStaysInItsMode() {
        arm();
        boat.mission(point(1, 0.001), point(2, 0.3));

        assertThat(boat.mode(STATION, OnboardModes.AUTO).words()).isEqualTo("item 2 is 33 km away");
        assertThat(boat.vehicle.mode()).isEqualTo(OnboardModes.LOITER);
        assertThat(boat.server.mode()).isEqualTo(BoatMode.HOLD);
    }

    @Test
    void goingOnBehindTheLastPlaceIsRefusedAndTheMissionGoesOn() {
        arm();
        boat.mission(point(1, 0.0001), point(2, 0.001), MissionItem.command(3, CHANGE_SPEED, 1, 2, -1));
        assertThat(boat.mode(STATION, OnboardModes.AUTO).isAccepted()).isTrue();
        boat.pass(20_000, STATION);
        assertThat(boat.mission.progress().item()).isEqualTo(2);

        assertThat(boat.order(STATION, new StationOrder.GoOnAt(3)).result()).isEqualTo(OrderReply.Result.DENIED);
        assertThat(boat.order(STATION, new StationOrder.StartMission(3)).result())
                .isEqualTo(OrderReply.Result.DENIED);
        assertThat(boat.mission.progress().item()).isEqualTo(2);
        assertThat(boat.server.mode()).isEqualTo(BoatMode.PATH);
        assertThat(boat.order(STATION, new StationOrder.GoOnAt(1)).isAccepted()).isTrue();
        assertThat(boat.mission.progress().item()).isEqualTo(1);
    }

    @Test
    void whatTheBoatSaysOfAnEarlierListCountsForNoNewOne() {
        arm();
        boat.mission(point(1, 0.0001), point(2, 0.0002));
        assertThat(boat.mode(STATION, OnboardModes.AUTO).isAccepted()).isTrue();
        boat.client.takeProgress();
        assertThat(boat.mode(STATION, OnboardModes.AUTO).isAccepted()).isTrue();
        List<Progress> last = boat.client.takeProgress();
        String listId = last.get(last.size() - 1).listId();

        BoatClient again = new BoatClient(boat.server, boat.nowMs);
        assertThat(again.isOwnList(again.newListId())).isTrue();
        assertThat(again.isOwnList(listId)).isFalse();
        assertThat(boat.client.isOwnList(listId)).isTrue();
        assertThat(boat.mission.take(new Progress("mission-1", 1, false), boat.nowMs))
                .isEmpty();
        assertThat(boat.mission.take(new Progress(listId, 9, true), boat.nowMs)).isEmpty(); // it has two places
        assertThat(boat.mission.take(new Progress(listId, 1, false), boat.nowMs))
                .hasValue(1);
    }
}
