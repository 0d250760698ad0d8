package org.sami.boat.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.CommandAsked;
import org.sami.boat.link.FleetRelease;
import org.sami.boat.link.GrantCommand;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.Role;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.TakeCommand;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.mavlink.address.AddressText;
import org.sami.mavlink.base.MavlinkBase;
import org.sami.mavlink.command.CommandOutcome;
import org.sami.mavlink.command.CommandPlace;
import org.sami.mavlink.command.CommandVerdict;
import org.sami.mavlink.command.VehicleCommand;
import org.sami.mavlink.mission.HeldKind;
import org.sami.mavlink.mission.MissionItem;
import org.sami.mavlink.vehicle.VehicleId;
import org.sami.mavlink.vehicle.VehicleKind;
import org.sami.mavlink.vehicle.VehicleSnapshot;

/** A boat of ours and a ground station, which is the base of the module mavlink, over UDP. */
@Tag("long")
@Timeout(900)
class GroundStationLinkTest {
    private static final VehicleId BOAT = new VehicleId(7, 1);

    private static MavlinkBase station(BoatWithStation boat) {
        return new MavlinkBase(List.of(AddressText.parse("mavlink:udp:" + boat.port)), ProcessClock::ms);
    }

    private static VehicleSnapshot seen(MavlinkBase station) {
        Await.until(
                "it is seen",
                () -> station.vehicles().join().stream()
                        .anyMatch(each -> each.located() && each.battery().isPresent()));
        return station.vehicles().join().get(0);
    }

    private static void untilMode(MavlinkBase station, String mode, boolean armed) {
        Await.until(
                mode, () -> seen(station).mode().equals(mode) && seen(station).armed() == armed);
    }

    private static MissionItem point(int number, double north, double waitS) {
        return MissionItem.waypoint(number, BoatWithStation.LAT + north, BoatWithStation.LON, 0, waitS);
    }

    private static CommandOutcome give(MavlinkBase station, VehicleCommand command) {
        return station.command(BOAT, command).join();
    }

    @Test
    void isASurfaceBoatWithPositionBatteryAndParameters() throws Exception {
        try (BoatWithStation boat = BoatWithStation.patient();
                MavlinkBase station = station(boat)) {
            VehicleSnapshot seen = seen(station);

            assertThat(seen.id()).isEqualTo(BOAT);
            assertThat(seen.kind()).isEqualTo(VehicleKind.BOAT);
            assertThat(seen.mode()).isEqualTo("HOLD");
            assertThat(seen.position().orElseThrow().latDeg()).isEqualTo(BoatWithStation.LAT);
            assertThat(seen.battery().orElseThrow().percent()).contains(90);
            SortedMap<String, Double> parameters = station.readParameters(BOAT).join();
            assertThat(parameters)
                    .containsEntry("FS_GCS_ENABLE", 1.0)
                    .containsEntry("FS_ACTION", 6.0)
                    .containsEntry("CRUISE_SPEED", 1.5)
                    .containsEntry("WP_RADIUS", 3.0);
            assertThat(station.setParameter(BOAT, "FS_ACTION", 1).join()).isEqualTo(1);
            assertThatThrownBy(() -> station.setParameter(BOAT, "WP_RADIUS", 9).join())
                    .hasMessageContaining("WP_RADIUS");
            assertThat(boat.link().heardAgoMs()).isPresent();
        }
    }

    @Test
    void carriesOutAMissionThatIsReadBackEqual() throws Exception {
        try (BoatWithStation boat = BoatWithStation.patient();
                MavlinkBase station = station(boat)) {
            seen(station);
            List<MissionItem> mission = List.of(
                    point(0, 0, 0),
                    MissionItem.command(1, 178, 1, 2.5, -1),
                    point(2, 0.0001, 0.5),
                    point(3, 0.0002, 0));

            List<MissionItem> held =
                    station.replace(BOAT, HeldKind.MISSION, mission).join();
            assertThat(held.get(2).isSameAs(mission.get(2))).isTrue();
            assertThat(boat.base().commandedBy()).isEmpty(); // a mission that is not started changes nothing

            assertThat(station.setMode(BOAT, "AUTO").join().isAccepted()).isTrue();
            assertThat(boat.base().mode()).isEqualTo(BoatMode.STOPPED);
            assertThat(give(station, VehicleCommand.arm()).isAccepted()).isTrue();
            untilMode(station, "LOITER", true); // at the end
            Await.until(
                    "its last item is told", () -> seen(station).currentItem().equals(Optional.of(3)));

            CommandPlace start = new CommandPlace(BoatWithStation.LAT, BoatWithStation.LON, 0);
            assertThat(station.setMode(BOAT, "GUIDED").join().isAccepted()).isTrue();
            assertThat(give(station, VehicleCommand.reposition(start, Optional.of(3.0)))
                            .isAccepted())
                    .isTrue();
            untilMode(station, "GUIDED", true);
            Await.until(
                    "it is there", () -> seen(station).position().orElseThrow().latDeg() < BoatWithStation.LAT + 4e-5);
            assertThat(give(station, VehicleCommand.disarm()).isAccepted()).isTrue();
            untilMode(station, "GUIDED", false);
            assertThat(boat.base().mode()).isEqualTo(BoatMode.STOPPED);
        }
    }

    @Test
    void obeysTheBaseThatCommandsAndAsksItsOperatorUntilItHandsOver() throws Exception {
        try (BoatWithStation boat = BoatWithStation.patient();
                MavlinkBase station = station(boat)) {
            boat.base().command(Role.COMMANDER);
            boat.base()
                    .send(id -> new UploadWaypoints(
                            id, "l1", List.of(new Waypoint(BoatWithStation.LAT + 0.01, BoatWithStation.LON, 1))));
            boat.base().send(id -> new StartWaypoints(id, "l1", 0));
            untilMode(station, "AUTO", true); // a station sees what the base has it do
            assertThat(station.held(BOAT, HeldKind.MISSION).join()).hasSize(2);

            CommandOutcome refused = station.setMode(BOAT, "LOITER").join();
            assertThat(refused.verdict()).isEqualTo(CommandVerdict.NOT_NOW);
            assertThat(refused.inWords()).contains("base1 commands anna");
            assertThatThrownBy(() -> station.replace(BOAT, HeldKind.MISSION, List.of(point(0, 0, 0), point(1, 1e-4, 0)))
                            .join())
                    .hasMessageContaining("MAV_MISSION_DENIED");
            assertThat(boat.base().mode()).isEqualTo(BoatMode.PATH);
            assertThat(boat.base().heard).hasAtLeastOneElementOfType(CommandAsked.class);

            assertThat(give(station, VehicleCommand.disarm()).isAccepted()).isTrue();
            assertThat(boat.base().mode()).isEqualTo(BoatMode.FLEET_STOP);
            boat.base().send(FleetRelease::new);
            boat.base().send(id -> new GrantCommand(id, BoatClient.NAME));
            assertThat(boat.base().commandedBy()).contains(BoatClient.NAME);
            assertThat(station.setMode(BOAT, "LOITER").join().isAccepted()).isTrue();
            assertThat(give(station, VehicleCommand.arm()).isAccepted()).isTrue();
            assertThat(boat.base().mode()).isEqualTo(BoatMode.HOLD);
        }
    }

    @Test
    void noParameterIsSetWhileABaseCommands() throws Exception {
        try (BoatWithStation boat = BoatWithStation.patient();
                MavlinkBase station = station(boat)) {
            seen(station);
            assertThat(station.setParameter(BOAT, "CRUISE_SPEED", 2).join()).isEqualTo(2);
            boat.base().command(Role.COMMANDER);
            assertThat(boat.base().commandedBy()).contains("base1");

            assertThatThrownBy(
                            () -> station.setParameter(BOAT, "CRUISE_SPEED", 3).join())
                    .hasMessageContaining("CRUISE_SPEED");
            assertThat(station.readParameters(BOAT).join()).containsEntry("CRUISE_SPEED", 2.0);
        }
    }

    @Test
    void aParameterThatCannotBeSetTakesNoCommand() throws Exception {
        try (BoatWithStation boat = BoatWithStation.patient();
                MavlinkBase station = station(boat)) {
            seen(station);
            assertThatThrownBy(() -> station.setParameter(BOAT, "FS_ACTION", 99).join())
                    .hasMessageContaining("FS_ACTION");
            assertThatThrownBy(() -> station.setParameter(BOAT, "HDG_P", -1).join())
                    .hasMessageContaining("HDG_P");
            assertThat(boat.base().commandedBy()).isEmpty();
        }
    }

    @Test
    void aPathOnWhichTheBaseGoesOnIsTheMissionAgain() throws Exception {
        try (BoatWithStation boat = BoatWithStation.patient();
                MavlinkBase station = station(boat)) {
            boat.base().command(Role.COMMANDER);
            boat.base()
                    .send(id -> new UploadWaypoints(
                            id,
                            "l1",
                            List.of(
                                    new Waypoint(BoatWithStation.LAT + 0.01, BoatWithStation.LON, 1),
                                    new Waypoint(BoatWithStation.LAT + 0.02, BoatWithStation.LON, 1))));
            boat.base().send(id -> new StartWaypoints(id, "l1", 0));
            untilMode(station, "AUTO", true);
            boat.base().send(id -> new GrantCommand(id, BoatClient.NAME));
            station.replace(BOAT, HeldKind.MISSION, List.of(point(0, 0, 0), point(1, -0.01, 0)))
                    .join();

            boat.base().send(id -> new TakeCommand(id, "session1", 9));
            boat.base().send(id -> new StartWaypoints(id, "l1", 1));
            Await.until(
                    "the base's path is shown",
                    () -> station.held(BOAT, HeldKind.MISSION).join().size() == 3);
        }
    }

    @Test
    void doesWhatIsSetForALostLinkWhenItsStationIsGone() throws Exception {
        try (BoatWithStation boat = BoatWithStation.losingIts(LostLinkAction.DRIFT)) {
            try (MavlinkBase station = station(boat)) {
                seen(station);
                station.setMode(BOAT, "LOITER").join();
                assertThat(give(station, VehicleCommand.arm()).isAccepted()).isTrue();
                assertThat(boat.base().mode()).isEqualTo(BoatMode.HOLD);
            }
            Await.until("it drifts", () -> boat.base().mode() == BoatMode.STOPPED);
            assertThat(boat.base().commandedBy()).isEmpty();

            try (MavlinkBase again = station(boat)) {
                untilMode(again, "HOLD", false);
                assertThat(again.setMode(BOAT, "LOITER").join().isAccepted()).isTrue();
                assertThat(give(again, VehicleCommand.arm()).isAccepted()).isTrue();
                untilMode(again, "LOITER", true);
            }
        }
    }

    /** As ground stations send it that choose no mode before. */
    private static VehicleCommand changingTheMode(VehicleCommand reposition) {
        List<Double> params = new ArrayList<>(reposition.params());
        params.set(1, 1.0);
        return new VehicleCommand(
                reposition.number(), reposition.does(), params, reposition.place(), reposition.newestWins());
    }

    @Test
    void refusesWhatABoatCannotDo() throws Exception {
        try (BoatWithStation boat = BoatWithStation.patient();
                MavlinkBase station = station(boat)) {
            seen(station);

            assertThat(give(station, VehicleCommand.of(22, "take off")).verdict())
                    .isEqualTo(CommandVerdict.UNKNOWN_TO_IT);
            assertThat(give(station, VehicleCommand.of(400, "arm", 2)).verdict())
                    .isEqualTo(CommandVerdict.DENIED);
            CommandPlace far = new CommandPlace(10, 10, 0);
            assertThat(give(station, changingTheMode(VehicleCommand.reposition(far, Optional.empty())))
                            .inWords())
                    .contains("km away");
            assertThat(station.setMode(BOAT, "AUTO").join().inWords()).contains("there is no mission");
            assertThat(give(station, VehicleCommand.setSpeed(1e30)).inWords())
                    .contains("a speed is 0.1 to 20.0, not 1.0");
            assertThat(boat.base().commandedBy()).isEmpty(); // what cannot be done takes no command
            CommandPlace near = new CommandPlace(BoatWithStation.LAT + 0.001, BoatWithStation.LON, 0);
            assertThat(give(station, VehicleCommand.reposition(near, Optional.empty()))
                            .inWords())
                    .contains("choose GUIDED first");
            station.setMode(BOAT, "GUIDED").join();
            assertThat(give(station, VehicleCommand.reposition(near, Optional.empty()))
                            .inWords())
                    .contains("anna is not armed");
            assertThat(station.setMode(BOAT, "STEERING").join().inWords()).contains("it has MANUAL, HOLD");
            assertThatThrownBy(() -> station.replace(
                                    BOAT,
                                    HeldKind.MISSION,
                                    List.of(point(0, 0, 0), MissionItem.command(1, 183, 1, 2, 3)))
                            .join())
                    .hasMessageContaining("MAV_MISSION_UNSUPPORTED");
            assertThatThrownBy(() -> station.replace(
                                    BOAT, HeldKind.RALLY, List.of(new MissionItem(0, 5100, 0, 45, 10, 0, 0, 0, 0, 0)))
                            .join())
                    .hasMessageContaining("MAV_MISSION_UNSUPPORTED");
            assertThat(boat.base().mode()).isEqualTo(BoatMode.STOPPED);
        }
    }
}
