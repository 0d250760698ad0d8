package org.sami.mavlink.onboard;

import static org.assertj.core.api.Assertions.assertThat;

import io.dronefleet.mavlink.common.CommandAck;
import io.dronefleet.mavlink.common.CommandInt;
import io.dronefleet.mavlink.common.CommandLong;
import io.dronefleet.mavlink.common.FenceStatus;
import io.dronefleet.mavlink.common.GlobalPositionInt;
import io.dronefleet.mavlink.common.MavCmd;
import io.dronefleet.mavlink.common.MavFrame;
import io.dronefleet.mavlink.common.MavMissionResult;
import io.dronefleet.mavlink.common.MavMissionType;
import io.dronefleet.mavlink.common.MavMode;
import io.dronefleet.mavlink.common.MavSysStatusSensor;
import io.dronefleet.mavlink.common.MissionAck;
import io.dronefleet.mavlink.common.MissionCount;
import io.dronefleet.mavlink.common.MissionItemInt;
import io.dronefleet.mavlink.common.ParamRequestRead;
import io.dronefleet.mavlink.common.ParamSet;
import io.dronefleet.mavlink.common.ParamValue;
import io.dronefleet.mavlink.common.Ping;
import io.dronefleet.mavlink.common.PositionTargetTypemask;
import io.dronefleet.mavlink.common.SetMode;
import io.dronefleet.mavlink.common.SetPositionTargetGlobalInt;
import io.dronefleet.mavlink.common.Statustext;
import io.dronefleet.mavlink.common.SysStatus;
import io.dronefleet.mavlink.common.Timesync;
import io.dronefleet.mavlink.minimal.Heartbeat;
import io.dronefleet.mavlink.minimal.MavType;
import io.dronefleet.mavlink.util.EnumValue;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.sami.mavlink.mission.HeldKind;
import org.sami.mavlink.mission.MissionItem;
import org.sami.mavlink.vehicle.VehicleId;

/** What a boat's end answers to messages, among them those that no station should send. */
@SuppressWarnings("deprecation") // stations that are older use the older messages
class OnboardVehicleTest {
    private static final VehicleId STATION = new VehicleId(255, 190);
    private static final int BOAT = 3;

    private final List<Object> sent = new ArrayList<>();
    private final List<StationOrder> orders = new ArrayList<>();
    private final OnboardVehicle vehicle = new OnboardVehicle("anna", BOAT, 5, new Scripted(), sent::add);
    private int heard;
    private Optional<ListKeeper.Refusal> noList = Optional.empty();
    private int changes;
    private Optional<ListKeeper.Refusal> noWhole = Optional.empty();
    private OnboardState.FenceState fence = OnboardState.FenceState.NONE;

    private final class Scripted implements OnboardHost {
        @Override
        public OnboardState state() {
            return new OnboardState(
                    Optional.of(new OnboardState.Place(45.4, 10.9, -Math.PI / 2, -1)),
                    Optional.empty(),
                    Optional.of(80.0),
                    OnboardState.BatteryState.OK,
                    OnboardModes.AUTO,
                    true,
                    false,
                    new OnboardState.MissionProgress(2, true, false),
                    fence);
        }

        @Override
        public void heard(VehicleId station) {
            heard++;
        }

        @Override
        public OrderReply order(VehicleId station, StationOrder order) {
            orders.add(order);
            return OrderReply.ACCEPTED;
        }

        @Override
        public List<OnboardParameter> parameters() {
            return List.of(new OnboardParameter("ONE", 1));
        }

        @Override
        public OrderReply setParameter(VehicleId station, String name, double value) {
            return OrderReply.denied("ONE is one");
        }

        @Override
        public Optional<Refusal> whyNoList(VehicleId station, HeldKind kind, int items) {
            return noList;
        }

        @Override
        public Optional<Refusal> whyNot(HeldKind kind, MissionItem item) {
            return item.command() == 16 ? Optional.empty() : Optional.of(Refusal.UNSUPPORTED);
        }

        @Override
        public Optional<Refusal> whyNotWhole(HeldKind kind, List<MissionItem> items) {
            return noWhole;
        }

        @Override
        public void changed(HeldKind kind, List<MissionItem> items) {
            changes++;
        }
    }

    private <T> List<T> answers(Class<T> kind, Object message) {
        sent.clear();
        vehicle.take(STATION, message, 1_000);
        return sent.stream().filter(kind::isInstance).map(kind::cast).toList();
    }

    private String text() {
        return sent.stream()
                .filter(Statustext.class::isInstance)
                .map(each -> ((Statustext) each).text())
                .findFirst()
                .orElse("");
    }

    private static CommandLong.Builder command(int number) {
        return CommandLong.builder()
                .targetSystem(BOAT)
                .targetComponent(1)
                .command(EnumValue.create(MavCmd.class, number));
    }

    @ParameterizedTest
    @CsvSource({
        "400, 1, 0, 0, 0, 0", // arm
        "400, 0.5, 0, 0, 0, 2",
        "400, NaN, 0, 0, 0, 2",
        "176, 1, 10, 0, 0, 0", // AUTO
        "176, 0, 10, 0, 0, 2", // no custom mode
        "176, 1, -1, 0, 0, 2",
        "176, 1, NaN, 0, 0, 2",
        "192, -1, 1, 45, 10, 0", // go to
        "192, -1, 1, 0, 0, 2",
        "192, -1, 1, NaN, 10, 2",
        "192, -1, 1, 95, 10, 2",
        "192, Infinity, 1, 45, 10, 2",
        "178, 1, 2, 0, 0, 0", // speed
        "178, 1, -1, 0, 0, 0",
        "178, 1, 0, 0, 0, 2",
        "178, 1, NaN, 0, 0, 2",
        "193, 0, 0, 0, 0, 0", // pause
        "193, 7, 0, 0, 0, 2",
        "300, -3, 0, 0, 0, 2",
        "512, 148, 0, 0, 0, 0", // version
        "512, 99999, 0, 0, 0, 2",
        "511, 33, 200000, 0, 0, 0",
        "511, 0, 200000, 0, 0, 2", // heartbeats come once a second
        "511, 33, NaN, 0, 0, 2",
        "246, 1, 0, 0, 0, 2", // restart
        "22, 0, 0, 0, 0, 3", // take off
        "65535, 0, 0, 0, 0, 3"
    })
    void answersEachCommandWithItsResult(int number, float p1, float p2, float p5, float p6, int result) {
        List<CommandAck> acks = answers(
                CommandAck.class,
                command(number).param1(p1).param2(p2).param5(p5).param6(p6).build());

        assertThat(acks).hasSize(1);
        assertThat(acks.get(0).command().value()).isEqualTo(number);
        assertThat(acks.get(0).result().value()).isEqualTo(result);
        assertThat(acks.get(0).targetSystem()).isEqualTo(255);
        assertThat(orders.size()).isLessThanOrEqualTo(result == 0 ? 1 : 0);
    }

    @Test
    void obeysNoMessageThatIsForAnotherVehicle() {
        assertThat(answers(Object.class, command(400).param1(1).targetSystem(4).build()))
                .isEmpty();
        assertThat(answers(
                        Object.class,
                        command(400).param1(1).targetComponent(100).build()))
                .isEmpty();
        vehicle.take(new VehicleId(BOAT, 191), command(400).param1(1).build(), 1_000); // another part of the boat
        assertThat(orders).isEmpty();
        assertThat(heard).isZero();
        assertThat(answers(
                        CommandAck.class, command(400).param1(1).targetSystem(0).build()))
                .hasSize(1); // for all
    }

    @Test
    void aHeartbeatOfAnotherVehicleIsNoStation() {
        vehicle.take(
                new VehicleId(4, 1),
                Heartbeat.builder().type(MavType.MAV_TYPE_SURFACE_BOAT).build(),
                0);
        assertThat(heard).isZero();
        vehicle.take(STATION, Heartbeat.builder().type(MavType.MAV_TYPE_GCS).build(), 0);
        assertThat(heard).isOne();
    }

    @Test
    void whatAnotherVehicleAsksAllIsAnsweredAndMakesItNoStation() {
        vehicle.take(new VehicleId(4, 1), Timesync.builder().ts1(77).build(), 1_000);
        vehicle.take(new VehicleId(4, 1), Ping.builder().seq(8).build(), 1_000);
        assertThat(sent).hasSize(2);
        assertThat(heard).isZero();

        vehicle.take(STATION, Timesync.builder().ts1(77).targetSystem(BOAT).build(), 1_000);
        assertThat(heard).isOne();
    }

    @Test
    void anOlderMessageForAModeIsObeyedOnlyWhereItNamesACustomMode() {
        answers(Object.class, mode(0));
        assertThat(text()).startsWith("a mode is a custom mode");
        answers(Object.class, mode(128));
        assertThat(orders).isEmpty();

        answers(Object.class, mode(1));
        assertThat(orders).containsExactly(new StationOrder.ChangeMode(OnboardModes.AUTO));
    }

    private static SetMode mode(int baseMode) {
        return SetMode.builder()
                .targetSystem(BOAT)
                .baseMode(EnumValue.create(MavMode.class, baseMode))
                .customMode(OnboardModes.AUTO)
                .build();
    }

    private static CommandInt reposition(MavFrame frame) {
        return CommandInt.builder()
                .targetSystem(BOAT)
                .frame(frame)
                .command(MavCmd.MAV_CMD_DO_REPOSITION)
                .param1(-1)
                .param2(1)
                .x(454_000_001)
                .y(-109_000_001)
                .build();
    }

    @ParameterizedTest
    @EnumSource(
            value = MavFrame.class,
            names = {"MAV_FRAME_LOCAL_NED", "MAV_FRAME_MISSION", "MAV_FRAME_BODY_FRD", "MAV_FRAME_LOCAL_FRD"})
    void aPlaceInMetresFromSomewhereIsRefused(MavFrame frame) {
        answers(CommandAck.class, reposition(frame));

        assertThat(orders).isEmpty();
        assertThat(text()).contains("no latitude and longitude");
    }

    @ParameterizedTest
    @EnumSource(
            value = MavFrame.class,
            names = {
                "MAV_FRAME_GLOBAL",
                "MAV_FRAME_GLOBAL_INT",
                "MAV_FRAME_GLOBAL_RELATIVE_ALT_INT",
                "MAV_FRAME_GLOBAL_TERRAIN_ALT_INT"
            })
    void placesInWholeNumbersAreExact(MavFrame frame) {
        answers(CommandAck.class, reposition(frame));

        assertThat(orders).containsExactly(new StationOrder.GoTo(45.4000001, -10.9000001, Optional.empty(), true));
    }

    @Test
    void aTargetWithoutAPlaceIsRefusedAndSaidOnce() {
        SetPositionTargetGlobalInt nowhere = SetPositionTargetGlobalInt.builder()
                .targetSystem(BOAT)
                .typeMask(EnumValue.create(PositionTargetTypemask.class, 0))
                .build();
        answers(Object.class, nowhere);
        assertThat(text()).startsWith("it is no place");
        assertThat(answers(Object.class, nowhere)).isEmpty();
        assertThat(orders).isEmpty();
    }

    @Test
    void parametersThatDoNotExistOrCannotBeSetAreNamed() {
        answers(
                Object.class,
                ParamRequestRead.builder()
                        .targetSystem(BOAT)
                        .paramId("TWO")
                        .paramIndex(-1)
                        .build());
        assertThat(text()).isEqualTo("no parameter TWO");
        answers(
                Object.class,
                ParamRequestRead.builder()
                        .targetSystem(BOAT)
                        .paramId("")
                        .paramIndex(9)
                        .build());
        assertThat(text()).isEqualTo("no parameter 9");
        List<ParamValue> kept = answers(
                ParamValue.class,
                ParamSet.builder()
                        .targetSystem(BOAT)
                        .paramId("ONE")
                        .paramValue(2)
                        .build());
        assertThat(kept.get(0).paramValue()).isEqualTo(1);
        assertThat(text()).isEqualTo("ONE is one");
        answers(
                Object.class,
                ParamSet.builder()
                        .targetSystem(BOAT)
                        .paramId("ONE")
                        .paramValue(Float.NaN)
                        .build());
        assertThat(text()).isEqualTo("ONE is no number");
    }

    private MavMissionResult result(Object message) {
        return answers(MissionAck.class, message).get(0).type().entry();
    }

    private static MissionCount count(int items) {
        return MissionCount.builder()
                .targetSystem(BOAT)
                .count(items)
                .missionType(MavMissionType.MAV_MISSION_TYPE_MISSION)
                .build();
    }

    private static MissionItemInt.Builder item(int number) {
        return MissionItemInt.builder()
                .targetSystem(BOAT)
                .seq(number)
                .command(MavCmd.MAV_CMD_NAV_WAYPOINT)
                .frame(MavFrame.MAV_FRAME_GLOBAL_RELATIVE_ALT_INT)
                .x(454_000_000)
                .y(109_000_000)
                .missionType(MavMissionType.MAV_MISSION_TYPE_MISSION);
    }

    @Test
    void missionsThatCannotBeAreRefusedWhole() {
        assertThat(result(count(6))).isEqualTo(MavMissionResult.MAV_MISSION_NO_SPACE);
        answers(Object.class, count(2));
        assertThat(result(item(1).build())).isEqualTo(MavMissionResult.MAV_MISSION_INVALID_SEQUENCE);
        assertThat(result(item(0).x(2_000_000_000).build())).isEqualTo(MavMissionResult.MAV_MISSION_INVALID_PARAM5_X);
        answers(Object.class, count(1));
        assertThat(result(item(0).command(MavCmd.MAV_CMD_NAV_LAND).build()))
                .isEqualTo(MavMissionResult.MAV_MISSION_UNSUPPORTED);
        assertThat(result(item(0).build())).isEqualTo(MavMissionResult.MAV_MISSION_ERROR); // none is expected
    }

    @Test
    void aMissionWhoseStationMayNotChangeItAtItsEndReplacesNothing() {
        answers(Object.class, count(2));
        answers(Object.class, item(0).build());
        noList = Optional.of(ListKeeper.Refusal.DENIED); // another station commands now

        assertThat(result(item(1).build())).isEqualTo(MavMissionResult.MAV_MISSION_DENIED);
        assertThat(changes).isZero();
        assertThat(result(item(1).build())).isEqualTo(MavMissionResult.MAV_MISSION_ERROR); // none is expected
    }

    /** Its acknowledgement was lost. */
    @Test
    void theLastItemOnceMoreIsAcknowledgedOnceMoreAndChangesNothing() {
        answers(Object.class, count(2));
        answers(Object.class, item(0).build());
        assertThat(result(item(1).build())).isEqualTo(MavMissionResult.MAV_MISSION_ACCEPTED);

        assertThat(result(item(1).build())).isEqualTo(MavMissionResult.MAV_MISSION_ACCEPTED);
        assertThat(result(item(0).build())).isEqualTo(MavMissionResult.MAV_MISSION_ERROR); // none is expected
        assertThat(changes).isOne();
    }

    @Test
    void aListThatIsWrongAsAWholeReplacesNothing() {
        answers(Object.class, count(1));
        noWhole = Optional.of(ListKeeper.Refusal.INVALID);

        assertThat(result(item(0).build())).isEqualTo(MavMissionResult.MAV_MISSION_INVALID);
        assertThat(changes).isZero();
    }

    @Test
    void reportsTheFenceAndItsBreachAlsoOfAFenceThatIsNoLongerHeld() {
        vehicle.fenceChanged();
        assertThat(sent).isEmpty();
        assertThat(geofence()).containsExactly(false, false, true);

        fence = new OnboardState.FenceState(true, true, true, 2, 4_000);
        sent.clear();
        vehicle.fenceChanged();
        FenceStatus breach = (FenceStatus) sent.get(0);
        assertThat(breach.breachStatus()).isOne();
        assertThat(breach.breachCount()).isEqualTo(2);
        assertThat(breach.breachTime()).isEqualTo(4_000);
        assertThat(geofence()).containsExactly(true, true, false);

        fence = new OnboardState.FenceState(false, false, false, 2, 4_000);
        sent.clear();
        vehicle.fenceChanged();
        assertThat(((FenceStatus) sent.get(0)).breachStatus()).isZero();
        assertThat(geofence()).containsExactly(false, false, true);
    }

    /** Whether the status says that there is a fence, that it is in force, and that it is not breached. */
    private List<Boolean> geofence() {
        CommandLong ask = command(512).param1(1).build();
        SysStatus status = answers(SysStatus.class, ask).get(0);
        MavSysStatusSensor part = MavSysStatusSensor.MAV_SYS_STATUS_GEOFENCE;
        return List.of(
                status.onboardControlSensorsPresent().flagsEnabled(part),
                status.onboardControlSensorsEnabled().flagsEnabled(part),
                status.onboardControlSensorsHealth().flagsEnabled(part));
    }

    @Test
    void anEmptyMissionEndsTheOneThatArrives() {
        answers(Object.class, count(2));

        assertThat(result(count(0))).isEqualTo(MavMissionResult.MAV_MISSION_ACCEPTED);
        assertThat(result(item(0).build())).isEqualTo(MavMissionResult.MAV_MISSION_ERROR);
        assertThat(changes).isOne();
    }

    @Test
    void reportsWhereItIsAsternToo() {
        vehicle.tick(5_000);
        GlobalPositionInt at = (GlobalPositionInt) sent.stream()
                .filter(GlobalPositionInt.class::isInstance)
                .findFirst()
                .orElseThrow();
        assertThat(at.lat()).isEqualTo(454_000_000);
        assertThat(at.hdg()).isEqualTo(27_000);
        assertThat(at.vx()).isZero();
        assertThat(at.vy()).isEqualTo(100); // astern of west is east
    }

    @Test
    void tellsItsTimeToWhoAsks() {
        List<Timesync> answers =
                answers(Timesync.class, Timesync.builder().tc1(0).ts1(77).build());
        assertThat(answers.get(0).ts1()).isEqualTo(77);
        assertThat(answers.get(0).tc1()).isEqualTo(1_000_000_000L);
        assertThat(answers(Timesync.class, Timesync.builder().tc1(5).ts1(77).build()))
                .isEmpty(); // an answer to somebody else
    }
}
