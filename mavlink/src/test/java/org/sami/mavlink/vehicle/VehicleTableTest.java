package org.sami.mavlink.vehicle;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.dronefleet.mavlink.ardupilotmega.CameraFeedback;
import io.dronefleet.mavlink.ardupilotmega.EkfStatusReport;
import io.dronefleet.mavlink.common.AutopilotVersion;
import io.dronefleet.mavlink.common.FenceStatus;
import io.dronefleet.mavlink.common.GlobalPositionInt;
import io.dronefleet.mavlink.common.MavSeverity;
import io.dronefleet.mavlink.common.MavSysStatusSensor;
import io.dronefleet.mavlink.common.MissionCurrent;
import io.dronefleet.mavlink.common.MissionItemReached;
import io.dronefleet.mavlink.common.NamedValueFloat;
import io.dronefleet.mavlink.common.Statustext;
import io.dronefleet.mavlink.common.SysStatus;
import io.dronefleet.mavlink.minimal.Heartbeat;
import io.dronefleet.mavlink.minimal.MavAutopilot;
import io.dronefleet.mavlink.minimal.MavModeFlag;
import io.dronefleet.mavlink.minimal.MavState;
import io.dronefleet.mavlink.minimal.MavType;
import io.dronefleet.mavlink.util.EnumValue;
import java.math.BigInteger;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.mavlink.address.AddressText;
import org.sami.mavlink.address.MavlinkAddress;

class VehicleTableTest {
    private static final MavlinkAddress RADIO = AddressText.parse("mavlink:serial:/dev/ttyUSB0:57600");
    private static final MavlinkAddress CABLE = AddressText.parse("mavlink:tcp:127.0.0.1:5760");

    private final VehicleTable table = new VehicleTable();

    private static Heartbeat beat(MavType type, MavAutopilot autopilot, long mode, MavModeFlag... flags) {
        return Heartbeat.builder()
                .type(type)
                .autopilot(autopilot)
                .customMode(mode)
                .baseMode(flags)
                .systemStatus(MavState.MAV_STATE_ACTIVE)
                .build();
    }

    private void heard(Object payload) {
        table.heard(new MessageOrigin(CABLE, 1, 1, 0), payload, 1_000);
    }

    private VehicleSnapshot only() {
        assertThat(table.vehicles()).hasSize(1);
        return table.vehicles().get(0);
    }

    @ParameterizedTest
    @CsvSource({
        "MAV_TYPE_SURFACE_BOAT, 10, BOAT, AUTO",
        "MAV_TYPE_SURFACE_BOAT, 4, BOAT, HOLD",
        "MAV_TYPE_GROUND_ROVER, 15, ROVER, GUIDED",
        "MAV_TYPE_QUADROTOR, 3, COPTER, AUTO",
        "MAV_TYPE_HEXAROTOR, 9, COPTER, LAND",
        "MAV_TYPE_SURFACE_BOAT, 99, BOAT, mode 99",
        "MAV_TYPE_FIXED_WING, 10, PLANE, mode 10"
    })
    void kindAndModeAreNamedAsPilotsNameThem(MavType type, long mode, VehicleKind kind, String name) {
        heard(beat(type, MavAutopilot.MAV_AUTOPILOT_ARDUPILOTMEGA, mode));

        assertThat(only().kind()).isEqualTo(kind);
        assertThat(only().mode()).isEqualTo(name);
        assertThat(only().autopilot()).isEqualTo("ArduPilot");
    }

    private List<VehicleEvent> after(long nowMs, Object payload) {
        return table.heard(new MessageOrigin(CABLE, 1, 1, 0), payload, nowMs);
    }

    private static Heartbeat beat(MavType type) {
        return beat(type, MavAutopilot.MAV_AUTOPILOT_ARDUPILOTMEGA, 4);
    }

    @Test
    void copterWithTheNumberOfABoatIsAnotherVehicle() {
        VehicleId id = new VehicleId(1, 1);
        after(1_000, beat(MavType.MAV_TYPE_SURFACE_BOAT));
        after(1_100, GlobalPositionInt.builder().lat(457_000_000).build());
        assertThat(table.mayFly(id, 1_500)).isFalse();

        assertThat(after(2_000, beat(MavType.MAV_TYPE_QUADROTOR)))
                .contains(new VehicleEvent.Replaced(id, VehicleKind.BOAT, VehicleKind.COPTER));
        assertThat(only().position()).isEmpty();
        assertThat(table.mayFly(id, 2_000)).isTrue();
        assertThat(after(3_000, beat(MavType.MAV_TYPE_QUADROTOR))).isEmpty();
    }

    @Test
    void boatAndCopterThatSpeakInTurnAreTwoWithOneIdAndNotOneAfterTheOther() {
        int replaced = 0;
        for (int s = 1; s <= 9; s++) {
            MavType type = s % 2 == 0 ? MavType.MAV_TYPE_QUADROTOR : MavType.MAV_TYPE_SURFACE_BOAT;
            replaced += (int) after(s * 1_000L, beat(type)).stream()
                    .filter(VehicleEvent.Replaced.class::isInstance)
                    .count();
        }

        assertThat(replaced).isEqualTo(2);
        assertThat(table.sharesId(new VehicleId(1, 1))).isTrue();
        assertThat(table.mayFly(new VehicleId(1, 1), 9_500)).isTrue();
    }

    @Test
    void vehicleThatIsNotHeardMayBeOneThatFlies() {
        VehicleId id = new VehicleId(1, 1);
        after(1_000, beat(MavType.MAV_TYPE_SURFACE_BOAT));

        assertThat(table.mayFly(id, 3_500)).isFalse();
        assertThat(table.mayFly(id, 4_500)).isTrue();
    }

    @ParameterizedTest
    @CsvSource({"MAV_TYPE_GROUND_ROVER, MAV_TYPE_SURFACE_BOAT", "MAV_TYPE_QUADROTOR, MAV_TYPE_GENERIC"})
    void autopilotThatIsSetUpOrStartsStaysTheSameVehicle(MavType before, MavType now) {
        after(1_000, beat(before));

        assertThat(after(2_000, beat(now))).noneMatch(VehicleEvent.Replaced.class::isInstance);
        assertThat(after(3_000, beat(before))).noneMatch(VehicleEvent.Replaced.class::isInstance);
    }

    @Test
    void autopilotWithAnotherNumberIsAnotherVehicle() {
        VehicleId id = new VehicleId(1, 1);
        after(1_000, beat(MavType.MAV_TYPE_SURFACE_BOAT));
        assertThat(only().number()).isEmpty();
        after(1_100, number(5));
        assertThat(only().number()).contains("5");
        assertThat(table.isNumberOpen(id)).isFalse();
        after(9_000, beat(MavType.MAV_TYPE_SURFACE_BOAT));
        assertThat(table.isNumberOpen(id)).isTrue();

        assertThat(after(9_100, number(0))).isEmpty();
        assertThat(only().number()).contains("");
        assertThat(after(9_200, number(5))).isEmpty();
        assertThat(after(9_300, number(6)))
                .containsExactly(new VehicleEvent.Replaced(id, VehicleKind.BOAT, VehicleKind.BOAT));
    }

    private static AutopilotVersion number(int number) {
        return AutopilotVersion.builder()
                .flightCustomVersion(new byte[8])
                .middlewareCustomVersion(new byte[8])
                .osCustomVersion(new byte[8])
                .uid(BigInteger.valueOf(number))
                .uid2(new byte[18])
                .build();
    }

    @Test
    void groundStationsAndGimbalsAreNoVehicles() {
        heard(beat(MavType.MAV_TYPE_GCS, MavAutopilot.MAV_AUTOPILOT_INVALID, 0));
        table.heard(
                new MessageOrigin(CABLE, 1, 154, 0),
                beat(MavType.MAV_TYPE_GIMBAL, MavAutopilot.MAV_AUTOPILOT_INVALID, 0),
                0);
        table.heard(
                new MessageOrigin(CABLE, 1, 1, 0), GlobalPositionInt.builder().build(), 0);

        assertThat(table.vehicles()).isEmpty();
    }

    @Test
    void valuesThatTheAutopilotDoesNotKnowAreEmptyAndNotZero() {
        heard(beat(MavType.MAV_TYPE_SURFACE_BOAT, MavAutopilot.MAV_AUTOPILOT_ARDUPILOTMEGA, 0));
        heard(SysStatus.builder()
                .onboardControlSensorsPresent(EnumValue.create(0))
                .onboardControlSensorsEnabled(EnumValue.create(0))
                .onboardControlSensorsHealth(EnumValue.create(0))
                .voltageBattery(65_535)
                .batteryRemaining(-1)
                .build());
        heard(GlobalPositionInt.builder()
                .lat(457_000_000)
                .lon(-1_072_000_000)
                .hdg(65_535)
                .vx(300)
                .vy(-400)
                .build());

        assertThat(only().battery()).contains(new VehicleBattery(Optional.empty(), Optional.empty()));
        VehiclePosition at = only().position().orElseThrow();
        assertThat(at.headingDeg()).isEmpty();
        assertThat(at.speedMps()).isEqualTo(5.0);
        assertThat(at.latDeg()).isCloseTo(45.7, within(1e-9));
        assertThat(at.lonDeg()).isCloseTo(-107.2, within(1e-9));
    }

    @Test
    void vehicleIsLocatedOnceItsFilterTrustsAnAbsolutePosition() {
        heard(beat(MavType.MAV_TYPE_SURFACE_BOAT, MavAutopilot.MAV_AUTOPILOT_ARDUPILOTMEGA, 0));
        heard(EkfStatusReport.builder().flags(EnumValue.create(16 + 128)).build());
        assertThat(only().located()).isFalse();
        heard(EkfStatusReport.builder().flags(EnumValue.create(16)).build());
        assertThat(only().located()).isTrue();
    }

    @Test
    void vehicleThatSpeaksOnWithoutSayingWhereItIsIsNotLocated() {
        heard(beat(MavType.MAV_TYPE_SURFACE_BOAT, MavAutopilot.MAV_AUTOPILOT_ARDUPILOTMEGA, 0));
        heard(EkfStatusReport.builder().flags(EnumValue.create(16)).build());
        heard(GlobalPositionInt.builder().lat(457_000_000).lon(107_200_000).build());
        beats(CABLE, 1, 6_000);
        assertThat(only().located()).isTrue();

        beats(CABLE, 2, 6_001);

        assertThat(only().located()).isFalse();
    }

    @Test
    void chargeBeyondFullIsNotKnown() {
        heard(beat(MavType.MAV_TYPE_SURFACE_BOAT, MavAutopilot.MAV_AUTOPILOT_ARDUPILOTMEGA, 0));
        heard(SysStatus.builder()
                .onboardControlSensorsPresent(EnumValue.create(0))
                .onboardControlSensorsEnabled(EnumValue.create(0))
                .onboardControlSensorsHealth(EnumValue.create(0))
                .voltageBattery(12_600)
                .batteryRemaining(127)
                .build());

        assertThat(only().battery().orElseThrow().percent()).isEmpty();
    }

    private void beats(MavlinkAddress link, int number, long ms) {
        table.heard(
                new MessageOrigin(link, 1, 1, number),
                beat(MavType.MAV_TYPE_SURFACE_BOAT, MavAutopilot.MAV_AUTOPILOT_PX4, 0),
                ms);
    }

    @Test
    void vehicleOnTwoLinksIsOneAndTheBetterIsUsedWhileTheOtherStaysReady() {
        recognized();
        for (int i = 0; i < 100; i++) {
            beats(RADIO, i * 2, 1_000 + i * 100);
            beats(CABLE, i, 1_010 + i * 100);
        }
        assertThat(only().links()).containsExactly(CABLE, RADIO);

        for (int i = 0; i < 40; i++) { // the cable is out
            beats(RADIO, 200 + i, 11_000 + i * 100);
        }
        assertThat(table.linkOf(only().id())).contains(RADIO);
        assertThat(only().heardMs()).isEqualTo(14_900);
    }

    @Test
    void linkIsNotChangedForALittle() {
        recognized();
        for (int i = 0; i < 100; i++) {
            beats(CABLE, i + i / 20, 1_000 + i * 100);
            beats(RADIO, i, 1_010 + i * 100);
        }

        assertThat(table.linkOf(only().id())).contains(CABLE);
    }

    private void place(double latDeg, long bootMs, long ms) {
        table.heard(
                new MessageOrigin(CABLE, 1, 1, 0),
                GlobalPositionInt.builder()
                        .lat((int) (latDeg * 1e7))
                        .lon(107_200_000)
                        .timeBootMs(bootMs)
                        .build(),
                ms);
    }

    @Test
    void twoVehiclesOfOneIdAreNoticedByTheirTimesAndPlaces() {
        beats(CABLE, 0, 1_000);
        for (int i = 0; i < 4; i++) {
            place(45.7, 100_000 + i, 1_000 + i * 250);
            place(45.7, 500_000 + i, 1_010 + i * 250);
        }
        assertThat(table.sharesId(only().id())).isTrue();
        assertThat(only().health().failing()).containsExactly("another vehicle has the id 1 too");

        for (int i = 0; i < 60; i++) { // one of them is switched off
            place(45.7, 600_000 + i * 250, 3_000 + i * 250);
        }
        assertThat(table.sharesId(only().id())).isFalse();
        for (int i = 0; i < 4; i++) {
            place(45.7, 700_000 + i, 30_000 + i * 250);
            place(45.71, 700_000 + i, 30_010 + i * 250);
        }
        assertThat(table.sharesId(only().id())).isTrue();
    }

    @Test
    void whatCannotBeIsNotBelieved() {
        beats(CABLE, 0, 1_000);
        for (int[] lie : new int[][] {{0, 0}, {2_000_000_000, 0}, {457_000_000, 1_900_000_000}}) {
            heard(GlobalPositionInt.builder().lat(lie[0]).lon(lie[1]).build());
            assertThat(only().position()).isEmpty();
        }
        assertThat(table.heard(
                        new MessageOrigin(CABLE, 1, 1, 0),
                        MissionItemReached.builder().seq(65_535).build(),
                        0))
                .isEmpty();
        heard(MissionCurrent.builder().seq(65_535).total(4).build());
        assertThat(only().currentItem()).isEmpty();
    }

    @Test
    void armedIsWhatTheHeartbeatSays() {
        heard(beat(
                MavType.MAV_TYPE_SURFACE_BOAT,
                MavAutopilot.MAV_AUTOPILOT_ARDUPILOTMEGA,
                10,
                MavModeFlag.MAV_MODE_FLAG_SAFETY_ARMED,
                MavModeFlag.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED));

        assertThat(only().armed()).isTrue();
    }

    @Test
    void textInPartsIsJoinedAndALostPartIsMarked() {
        heard(beat(MavType.MAV_TYPE_SURFACE_BOAT, MavAutopilot.MAV_AUTOPILOT_ARDUPILOTMEGA, 0));
        String first = "x".repeat(50);
        heard(part(7, 0, first));
        heard(part(7, 1, "end"));
        heard(part(8, 0, first));
        heard(part(8, 2, "end"));
        heard(part(0, 0, "short"));

        assertThat(only().texts())
                .extracting(StatusText::text)
                .isEqualTo(List.of(first + "end", first + " … end", "short"));
        assertThat(only().texts().get(0).severity()).isEqualTo(TextSeverity.WARNING);
    }

    @Test
    void textWhoseEndIsLostIsToldAfterTwoSecondsAsFarAsItHasCome() {
        String first = "a".repeat(50);
        heard(beat(MavType.MAV_TYPE_SURFACE_BOAT, MavAutopilot.MAV_AUTOPILOT_ARDUPILOTMEGA, 4));
        table.heard(new MessageOrigin(CABLE, 1, 1, 0), part(7, 0, first), 5_000);

        assertThat(table.tick(6_900)).isEmpty();
        assertThat(table.tick(7_000))
                .containsExactly(new VehicleEvent.Said(
                        new VehicleId(1, 1), new StatusText(TextSeverity.WARNING, first + " …", 5_000)));
        assertThat(table.tick(20_000)).isEmpty();
        assertThat(only().texts()).extracting(StatusText::text).containsExactly(first + " …");
    }

    private static Statustext part(int id, int number, String text) {
        return Statustext.builder()
                .severity(MavSeverity.MAV_SEVERITY_WARNING)
                .id(id)
                .chunkSeq(number)
                .text(text)
                .build();
    }

    @Test
    void changesAreEventsOnceEach() {
        List<VehicleEvent> events = new ArrayList<>();
        for (Object message : List.of(
                beat(MavType.MAV_TYPE_SURFACE_BOAT, MavAutopilot.MAV_AUTOPILOT_ARDUPILOTMEGA, 4),
                beat(MavType.MAV_TYPE_SURFACE_BOAT, MavAutopilot.MAV_AUTOPILOT_ARDUPILOTMEGA, 4),
                beat(
                        MavType.MAV_TYPE_SURFACE_BOAT,
                        MavAutopilot.MAV_AUTOPILOT_ARDUPILOTMEGA,
                        10,
                        MavModeFlag.MAV_MODE_FLAG_SAFETY_ARMED),
                MissionCurrent.builder().seq(2).total(5).build(),
                MissionCurrent.builder().seq(2).total(5).build(),
                MissionItemReached.builder().seq(2).build(),
                NamedValueFloat.builder().name("DO").value(8.5f).build(),
                NamedValueFloat.builder().name("DO").value(Float.NaN).build(),
                GlobalPositionInt.builder().timeBootMs(90_000).build(),
                GlobalPositionInt.builder().timeBootMs(89_900).build(),
                GlobalPositionInt.builder().timeBootMs(2_000).build())) {
            events.addAll(table.heard(new MessageOrigin(CABLE, 1, 1, 0), message, 1_000));
        }

        VehicleId one = new VehicleId(1, 1);
        assertThat(events)
                .containsExactly(
                        new VehicleEvent.Appeared(one),
                        new VehicleEvent.ModeChanged(one, "HOLD", "AUTO"),
                        new VehicleEvent.ArmedChanged(one, true),
                        new VehicleEvent.ItemCurrent(one, 2, 1_000),
                        new VehicleEvent.ItemReached(one, 2, Optional.empty(), 1_000),
                        new VehicleEvent.Measured(one, new VehicleReading("DO", 8.5, "")),
                        new VehicleEvent.Restarted(one));
        assertThat(only().currentItem()).contains(2);
        assertThat(only().itemsHeld()).contains(5);
        assertThat(table.modeNumber(one, "guided")).contains(15L);
        assertThat(table.modeNumber(one, "FLY")).isEmpty();
    }

    @Test
    void whetherItsFenceIsInForceIsWhatItSaysAndNotWhatItsParametersSay() {
        int fence = EnumValue.of(MavSysStatusSensor.MAV_SYS_STATUS_GEOFENCE).value();
        heard(beat(MavType.MAV_TYPE_SURFACE_BOAT, MavAutopilot.MAV_AUTOPILOT_ARDUPILOTMEGA, 4));
        saysOfItsFence(0, 0);
        assertThat(only().health().fenceOn()).isEmpty();
        saysOfItsFence(fence, 0);
        assertThat(only().health().fenceOn()).contains(false);
        saysOfItsFence(fence, fence);
        assertThat(only().health().fenceOn()).contains(true);
    }

    private void saysOfItsFence(int present, int enabled) {
        heard(SysStatus.builder()
                .onboardControlSensorsPresent(EnumValue.create(present))
                .onboardControlSensorsEnabled(EnumValue.create(enabled))
                .onboardControlSensorsHealth(EnumValue.create(present))
                .build());
    }

    @Test
    void whatIsWrongWithItIsNamed() {
        heard(Heartbeat.builder()
                .type(MavType.MAV_TYPE_SURFACE_BOAT)
                .autopilot(MavAutopilot.MAV_AUTOPILOT_ARDUPILOTMEGA)
                .baseMode(EnumValue.create(0))
                .systemStatus(MavState.MAV_STATE_CRITICAL)
                .build());
        heard(SysStatus.builder()
                .onboardControlSensorsPresent(EnumValue.create(0))
                .onboardControlSensorsEnabled(
                        MavSysStatusSensor.MAV_SYS_STATUS_SENSOR_GPS, MavSysStatusSensor.MAV_SYS_STATUS_SENSOR_BATTERY)
                .onboardControlSensorsHealth(
                        MavSysStatusSensor.MAV_SYS_STATUS_SENSOR_BATTERY,
                        MavSysStatusSensor.MAV_SYS_STATUS_PREARM_CHECK)
                .build());
        heard(FenceStatus.builder().breachStatus(1).build());

        assertThat(only().health()).isEqualTo(new VehicleHealth(true, true, true, Optional.empty(), List.of("gps")));
    }

    @Test
    void pictureHasItsOwnPlaceOrElseTheVehicles() {
        heard(beat(MavType.MAV_TYPE_SURFACE_BOAT, MavAutopilot.MAV_AUTOPILOT_ARDUPILOTMEGA, 4));
        assertThat(pictures(4, 0, 0)).isEmpty(); // nowhere
        heard(GlobalPositionInt.builder().lat(450_000_000).lon(100_000_000).build());

        VehicleId one = new VehicleId(1, 1);
        assertThat(pictures(5, 450_000_010, 100_000_000))
                .containsExactly(new VehicleEvent.PictureTaken(one, 5, 450_000_010 * 1e-7, 100_000_000 * 1e-7));
        assertThat(pictures(6, 0, 0))
                .containsExactly(new VehicleEvent.PictureTaken(one, 6, 450_000_000 * 1e-7, 100_000_000 * 1e-7));
    }

    private List<VehicleEvent> pictures(int number, int lat, int lng) {
        return table.heard(
                new MessageOrigin(CABLE, 1, 1, 0),
                CameraFeedback.builder().imgIdx(number).lat(lat).lng(lng).build(),
                1_000);
    }

    /** The vehicle is heard on cable and radio, and is one. */
    private void recognized() {
        beats(CABLE, 0, 0);
        says(CABLE, 7, 0);
        says(RADIO, 7, 0);
        position(CABLE, 45.7, 100_000, 0);
        assertThat(position(RADIO, 45.7, 100_100, 10))
                .contains(new VehicleEvent.LinkJoined(new VehicleId(1, 1), RADIO));
    }

    private void says(MavlinkAddress link, int number, long ms) {
        byte[] uid = new byte[18];
        uid[3] = (byte) number;
        table.heard(
                new MessageOrigin(link, 1, 1, 0),
                AutopilotVersion.builder().uid(BigInteger.ZERO).uid2(uid).build(),
                ms);
    }

    private List<VehicleEvent> position(MavlinkAddress link, double latDeg, long bootMs, long ms) {
        return table.heard(
                new MessageOrigin(link, 1, 1, 0),
                GlobalPositionInt.builder()
                        .lat((int) (latDeg * 1e7))
                        .lon(107_200_000)
                        .timeBootMs(bootMs)
                        .build(),
                ms);
    }

    @ParameterizedTest
    @CsvSource({
        "7, 45.7, 500000, 3", // as many positions as it takes; a copied memory card
        "7, 45.8, 100000, 3", // started together, 11 km apart
        "8, 45.7, 100000, 1", // side by side, started together
        "0, 45.8, 100000, 3" // without a number
    })
    void anotherVehicleOfItsIdOnAnotherLinkIsNamedAndNothingOfItIsTaken(
            int number, double latDeg, long bootMs, int positions) {
        beats(CABLE, 0, 0);
        says(CABLE, 7, 0);
        position(CABLE, 45.7, 100_000, 0);
        says(RADIO, number, 5);
        List<VehicleEvent> events = new ArrayList<>();
        for (int i = 0; i < 5; i++) {
            events.addAll(position(RADIO, latDeg, bootMs + i * 1_000L, i * 1_000L));
            if (i + 1 < positions) {
                assertThat(events).isEmpty();
            }
        }

        VehicleId one = new VehicleId(1, 1);
        assertThat(events).hasSizeLessThanOrEqualTo(1);
        assertThat(only().others()).containsExactly(RADIO);
        assertThat(only().links()).containsExactly(CABLE);
        assertThat(only().health().failing()).containsExactly("another vehicle has the id 1 on " + RADIO);
        assertThat(only().position().orElseThrow().latDeg()).isCloseTo(45.7, within(1e-6));
        assertThat(table.isForeign(one, RADIO)).isTrue();
        assertThat(table.sharesId(one)).isFalse();
    }

    @Test
    void vehicleWithoutANumberIsRecognizedByItsTimeAndPlaceAfterThreeSeconds() {
        beats(CABLE, 0, 0);
        for (int i = 0; i < 30; i++) {
            position(CABLE, 45.7, 100_000 + i * 100L, i * 100L);
            position(RADIO, 45.7, 99_500 + i * 100L, i * 100L); // half a second late
        }
        assertThat(only().links()).containsExactly(CABLE);

        assertThat(position(RADIO, 45.7, 102_500, 3_000)).hasSize(1);
        assertThat(only().links()).containsExactly(CABLE, RADIO);
    }

    @Test
    void vehicleThatStartsAgainWhileItsFirstLinkIsSilentIsRecognizedByItsNumber() {
        beats(CABLE, 0, 0);
        says(CABLE, 7, 0);
        position(CABLE, 45.7, 900_000, 0);
        says(RADIO, 7, 5_000);
        position(RADIO, 45.7, 2_000, 5_000);
        assertThat(only().links()).containsExactly(CABLE);

        assertThat(position(RADIO, 45.7, 8_000, 10_001))
                .contains(
                        new VehicleEvent.LinkJoined(new VehicleId(1, 1), RADIO),
                        new VehicleEvent.Restarted(new VehicleId(1, 1)));
    }

    @Test
    void whatComesOnBothLinksIsTakenOnce() {
        recognized();
        List<VehicleEvent> events = new ArrayList<>();
        for (MavlinkAddress link : List.of(CABLE, RADIO)) {
            for (Object message : List.of(
                    part(3, 0, "x".repeat(50)),
                    part(3, 1, "end"),
                    part(0, 0, "again"),
                    part(0, 0, "again"),
                    MissionItemReached.builder().seq(2).build(),
                    CameraFeedback.builder().imgIdx(4).lat(1).lng(1).build(),
                    NamedValueFloat.builder().name("DO").value(8.5f).build())) {
                events.addAll(table.heard(new MessageOrigin(link, 1, 1, 0), message, 500));
            }
        }

        assertThat(events).filteredOn(VehicleEvent.Said.class::isInstance).hasSize(3);
        assertThat(events)
                .filteredOn(VehicleEvent.ItemReached.class::isInstance)
                .hasSize(1);
        assertThat(events)
                .filteredOn(VehicleEvent.PictureTaken.class::isInstance)
                .hasSize(1);
        assertThat(events).filteredOn(VehicleEvent.Measured.class::isInstance).hasSize(1);
    }

    @Test
    void textWhoseEndIsLostOnOneLinkIsNotToldAgainWhereItCameWholeOnTheOther() {
        recognized();
        String first = "x".repeat(50);
        for (Object message : List.of(part(3, 0, first), part(3, 1, "end"))) {
            table.heard(new MessageOrigin(CABLE, 1, 1, 0), message, 500);
        }
        table.heard(new MessageOrigin(RADIO, 1, 1, 0), part(3, 0, first), 600);

        assertThat(table.tick(5_000)).isEmpty();
        assertThat(only().texts()).extracting(StatusText::text).containsExactly(first + "end");
    }

    @Test
    void linkThatIsBehindDoesNotSayHowTheVehicleIsNowUnlessTheOtherIsSilent() {
        recognized();
        MissionCurrent third = MissionCurrent.builder().seq(3).total(5).build();
        MissionCurrent second = MissionCurrent.builder().seq(2).total(5).build();
        table.heard(new MessageOrigin(CABLE, 1, 1, 0), third, 1_000);
        assertThat(table.heard(new MessageOrigin(RADIO, 1, 1, 0), second, 1_100))
                .isEmpty();
        assertThat(only().currentItem()).contains(3);

        table.heard(new MessageOrigin(RADIO, 1, 1, 0), second, 2_101);
        assertThat(only().currentItem()).contains(2);
    }

    @Test
    void changeOfTheLinkIsToldWithItsReason() {
        recognized();
        List<VehicleEvent> events = new ArrayList<>();
        for (int i = 1; i <= 40; i++) {
            events.addAll(table.heard(
                    new MessageOrigin(RADIO, 1, 1, i),
                    beat(MavType.MAV_TYPE_SURFACE_BOAT, MavAutopilot.MAV_AUTOPILOT_ARDUPILOTMEGA, 0),
                    i * 100L));
        }

        assertThat(events)
                .filteredOn(VehicleEvent.LinkChanged.class::isInstance)
                .containsExactly(
                        new VehicleEvent.LinkChanged(new VehicleId(1, 1), CABLE, RADIO, "has been silent for 2.6 s"));
    }
}
