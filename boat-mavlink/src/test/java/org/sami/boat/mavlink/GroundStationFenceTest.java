package org.sami.boat.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.sami.boat.mavlink.BoatWithStation.LAT;
import static org.sami.boat.mavlink.BoatWithStation.LON;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.Role;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.mavlink.address.AddressText;
import org.sami.mavlink.base.MavlinkBase;
import org.sami.mavlink.command.CommandPlace;
import org.sami.mavlink.command.VehicleCommand;
import org.sami.mavlink.mission.HeldKind;
import org.sami.mavlink.mission.MissionItem;
import org.sami.mavlink.vehicle.VehicleId;

/** A boat of ours and the fence that a ground station gives it, over UDP. */
@Tag("long")
@Timeout(900)
class GroundStationFenceTest {
    private static final VehicleId BOAT = new VehicleId(7, 1);
    private static final List<MissionItem> FENCE = FencePart.list(
            FencePart.square(FencePart.INCLUSION, LAT, LON, 0.001),
            FencePart.circle(FencePart.CIRCLE_EXCLUSION, LAT + 0.0008, LON, 10),
            FencePart.polygon(FencePart.EXCLUSION, new double[][] {
                {LAT - 0.0009, LON}, {LAT - 0.0008, LON + 0.0001}, {LAT - 0.0008, LON - 0.0001}
            }));

    private BoatWithStation boat;
    private MavlinkBase station;

    @BeforeEach
    void launch() throws Exception {
        boat = BoatWithStation.patient();
        station = new MavlinkBase(List.of(AddressText.parse("mavlink:udp:" + boat.port)), ProcessClock::ms);
        Await.until(
                "it is seen",
                () -> station.vehicles().join().stream()
                        .anyMatch(each -> each.located() && each.battery().isPresent()));
    }

    @AfterEach
    void end() throws Exception {
        station.close();
        boat.close();
    }

    private List<MissionItem> held() {
        return station.held(BOAT, HeldKind.FENCE).join();
    }

    private List<MissionItem> replace(List<MissionItem> fence) {
        return station.replace(BOAT, HeldKind.FENCE, fence).join();
    }

    private void untilSaid(String text) {
        Await.until(
                text,
                () -> station.vehicles().join().get(0).texts().stream()
                        .anyMatch(each -> each.text().equals(text)));
    }

    private void untilOutside(boolean outside) {
        Await.until(
                "outside: " + outside,
                () -> station.vehicles().join().get(0).health().outsideFence() == outside);
    }

    @Test
    void isHeldAsItWasSentUntilItIsRemoved() {
        assertThat(held()).isEmpty();

        List<MissionItem> back = replace(FENCE);
        assertThat(back).hasSameSizeAs(FENCE);
        for (int i = 0; i < FENCE.size(); i++) {
            assertThat(back.get(i).isSameAs(FENCE.get(i))).isTrue();
        }
        assertThat(held()).isEqualTo(back);

        replace(List.of());
        assertThat(held()).isEmpty();
    }

    @Test
    void isRefusedWholeWithItsReasonAndTheOneBeforeStays() {
        replace(FENCE);

        assertThatThrownBy(() -> replace(FENCE.subList(0, 3))).hasMessageContaining("MAV_MISSION_INVALID");
        untilSaid("fence items 0 to 3 should be one polygon of 4 corners, and 3 are");
        assertThatThrownBy(() -> replace(List.of(FencePart.item(5005, LAT, LON, 30, 0))))
                .hasMessageContaining("MAV_MISSION_UNSUPPORTED");
        untilSaid("fence item 0: a boat of SAMI has no command 5005");
        List<MissionItem> many = new ArrayList<>(Collections.nCopies(501, FENCE.get(4)));
        assertThatThrownBy(() -> replace(FencePart.list(many))).hasMessageContaining("MAV_MISSION_NO_SPACE");
        untilSaid("a fence of anna has at most 500 items");
        boat.base().command(Role.COMMANDER);
        assertThatThrownBy(() -> replace(List.of())).hasMessageContaining("MAV_MISSION_DENIED");
        assertThat(held()).hasSameSizeAs(FENCE);
    }

    @Test
    void bindsWhatTheStationOrdersAndABreachIsReported() {
        replace(FENCE);
        station.setMode(BOAT, "LOITER").join();
        assertThat(station.command(BOAT, VehicleCommand.arm()).join().isAccepted())
                .isTrue();
        CommandPlace outside = new CommandPlace(LAT + 0.002, LON, 0);
        assertThat(station.command(BOAT, VehicleCommand.reposition(outside, Optional.empty()))
                        .join()
                        .inWords())
                .contains("the place is outside of the fence");
        assertThat(boat.base().mode()).isEqualTo(BoatMode.HOLD);

        CommandPlace inside = new CommandPlace(LAT + 0.0006, LON, 0);
        station.setMode(BOAT, "GUIDED").join();
        assertThat(station.command(BOAT, VehicleCommand.reposition(inside, Optional.empty()))
                        .join()
                        .isAccepted())
                .isTrue();
        replace(FencePart.list(FencePart.square(FencePart.INCLUSION, LAT + 0.002, LON, 0.0005)));
        untilOutside(true);
        untilSaid("anna is outside of its fence and keeps its place");
        assertThat(boat.base().mode()).isEqualTo(BoatMode.HOLD);

        replace(List.of());
        untilOutside(false);
    }
}
