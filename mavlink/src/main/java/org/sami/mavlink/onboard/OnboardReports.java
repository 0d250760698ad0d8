package org.sami.mavlink.onboard;

import io.dronefleet.mavlink.ardupilotmega.EkfStatusFlags;
import io.dronefleet.mavlink.ardupilotmega.EkfStatusReport;
import io.dronefleet.mavlink.common.Attitude;
import io.dronefleet.mavlink.common.BatteryStatus;
import io.dronefleet.mavlink.common.FenceBreach;
import io.dronefleet.mavlink.common.FenceMitigate;
import io.dronefleet.mavlink.common.FenceStatus;
import io.dronefleet.mavlink.common.GlobalPositionInt;
import io.dronefleet.mavlink.common.GpsFixType;
import io.dronefleet.mavlink.common.GpsRawInt;
import io.dronefleet.mavlink.common.HomePosition;
import io.dronefleet.mavlink.common.MavBatteryChargeState;
import io.dronefleet.mavlink.common.MavBatteryFunction;
import io.dronefleet.mavlink.common.MissionCurrent;
import io.dronefleet.mavlink.common.MissionState;
import io.dronefleet.mavlink.common.VfrHud;
import io.dronefleet.mavlink.minimal.Heartbeat;
import io.dronefleet.mavlink.minimal.MavAutopilot;
import io.dronefleet.mavlink.minimal.MavModeFlag;
import io.dronefleet.mavlink.minimal.MavState;
import io.dronefleet.mavlink.minimal.MavType;
import io.dronefleet.mavlink.util.EnumValue;
import java.math.BigInteger;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.sami.mavlink.onboard.OnboardState.FenceState;
import org.sami.mavlink.onboard.OnboardState.MissionProgress;
import org.sami.mavlink.onboard.OnboardState.Place;

/** Writes the state of a surface boat as the messages that ground stations know. What a boat does not know has the protocol's value for that. */
final class OnboardReports {
    private static final double TO_WHOLE = 1e7;
    private static final double TO_CENTI = 100;
    private static final double MICROS = 1000; // a millisecond has
    private static final int UNKNOWN = 0xffff;
    private static final int UNKNOWN_BYTE = 0xff;
    private static final int CELLS = 10;
    private static final int WHOLE_TURN_DEG = 360;

    private OnboardReports() {}

    static Heartbeat heartbeat(OnboardState state) {
        MavState status = state.isCritical()
                ? MavState.MAV_STATE_CRITICAL
                : state.isArmed() ? MavState.MAV_STATE_ACTIVE : MavState.MAV_STATE_STANDBY;
        Heartbeat.Builder beat = Heartbeat.builder()
                .type(MavType.MAV_TYPE_SURFACE_BOAT)
                .autopilot(MavAutopilot.MAV_AUTOPILOT_ARDUPILOTMEGA)
                .customMode(state.customMode())
                .systemStatus(status)
                .mavlinkVersion(3);
        return state.isArmed()
                ? beat.baseMode(MavModeFlag.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED, MavModeFlag.MAV_MODE_FLAG_SAFETY_ARMED)
                        .build()
                : beat.baseMode(MavModeFlag.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED).build();
    }

    static Optional<Object> position(OnboardState state, long bootMs) {
        return state.place()
                .map(at -> GlobalPositionInt.builder()
                        .timeBootMs(bootMs)
                        .lat(whole(at.latDeg()))
                        .lon(whole(at.lonDeg()))
                        .vx((int) Math.round(at.speedMps() * Math.cos(at.headingRad()) * TO_CENTI))
                        .vy((int) Math.round(at.speedMps() * Math.sin(at.headingRad()) * TO_CENTI))
                        .hdg((int) Math.round(courseDeg(at.headingRad()) * TO_CENTI))
                        .build());
    }

    /** The receiver's own numbers, such as its satellites, are not known to a boat's server. */
    static Object gps(OnboardState state, long bootMs) {
        GpsRawInt.Builder raw = GpsRawInt.builder()
                .timeUsec(micros(bootMs))
                .eph(UNKNOWN)
                .epv(UNKNOWN)
                .satellitesVisible(UNKNOWN_BYTE);
        if (state.place().isEmpty()) {
            return raw.fixType(GpsFixType.GPS_FIX_TYPE_NO_FIX)
                    .vel(UNKNOWN)
                    .cog(UNKNOWN)
                    .build();
        }
        Place at = state.place().get();
        double over = at.speedMps() < 0 ? at.headingRad() + Math.PI : at.headingRad();
        return raw.fixType(GpsFixType.GPS_FIX_TYPE_3D_FIX)
                .lat(whole(at.latDeg()))
                .lon(whole(at.lonDeg()))
                .vel((int) Math.round(Math.abs(at.speedMps()) * TO_CENTI))
                .cog((int) Math.round(courseDeg(over) * TO_CENTI))
                .build();
    }

    /** A boat knows its heading; it is taken to lie level. */
    static Optional<Object> attitude(OnboardState state, long bootMs) {
        return state.place()
                .map(at -> Attitude.builder()
                        .timeBootMs(bootMs)
                        .yaw((float) Math.IEEEremainder(at.headingRad(), 2 * Math.PI))
                        .build());
    }

    static Optional<Object> hud(OnboardState state) {
        return state.place()
                .map(at -> VfrHud.builder()
                        .airspeed((float) Math.abs(at.speedMps()))
                        .groundspeed((float) Math.abs(at.speedMps()))
                        .heading((int) Math.round(courseDeg(at.headingRad())) % WHOLE_TURN_DEG)
                        .build());
    }

    static Object battery(OnboardState state) {
        MavBatteryChargeState level = switch (state.batteryState()) {
            case OK -> MavBatteryChargeState.MAV_BATTERY_CHARGE_STATE_OK;
            case LOW -> MavBatteryChargeState.MAV_BATTERY_CHARGE_STATE_LOW;
            case CRITICAL -> MavBatteryChargeState.MAV_BATTERY_CHARGE_STATE_CRITICAL;
        };
        return BatteryStatus.builder()
                .batteryFunction(MavBatteryFunction.MAV_BATTERY_FUNCTION_ALL)
                .temperature(Short.MAX_VALUE)
                .voltages(Collections.nCopies(CELLS, UNKNOWN))
                .voltagesExt(List.of(0, 0, 0, 0))
                .currentBattery(-1)
                .currentConsumed(-1)
                .energyConsumed(-1)
                .batteryRemaining(percent(state))
                .chargeState(level)
                .build();
    }

    /** Percent of charge; -1 where it is not known. */
    static int percent(OnboardState state) {
        return state.batteryPercent().map(percent -> (int) Math.round(percent)).orElse(-1);
    }

    /** The position filter, as ArduPilot reports its own: bases go by it before they send a vehicle anywhere. */
    static Object filter(OnboardState state) {
        EkfStatusReport.Builder report = EkfStatusReport.builder();
        return state.place().isPresent()
                ? report.flags(
                                EkfStatusFlags.EKF_ATTITUDE,
                                EkfStatusFlags.EKF_VELOCITY_HORIZ,
                                EkfStatusFlags.EKF_POS_HORIZ_REL,
                                EkfStatusFlags.EKF_POS_HORIZ_ABS,
                                EkfStatusFlags.EKF_PRED_POS_HORIZ_REL,
                                EkfStatusFlags.EKF_PRED_POS_HORIZ_ABS)
                        .build()
                : report.flags(EnumValue.create(EkfStatusFlags.class, 0)).build();
    }

    static Object missionCurrent(OnboardState state, int items) {
        MissionProgress mission = state.mission();
        MissionState phase = items == 0
                ? MissionState.MISSION_STATE_NO_MISSION
                : mission.isDone()
                        ? MissionState.MISSION_STATE_COMPLETE
                        : mission.isUnderWay()
                                ? MissionState.MISSION_STATE_ACTIVE
                                : mission.item() > 1
                                        ? MissionState.MISSION_STATE_PAUSED
                                        : MissionState.MISSION_STATE_NOT_STARTED;
        return MissionCurrent.builder()
                .seq(mission.item())
                .total(items == 0 ? UNKNOWN : items - 1) // ArduPilot's home does not count
                .missionState(phase)
                .missionMode(mission.isUnderWay() ? 1 : 2)
                .build();
    }

    /** Also of a fence that is no longer held: stations would go on showing its breach. */
    static Optional<Object> fence(OnboardState state) {
        FenceState fence = state.fence();
        return !fence.isHeld() && fence.breaches() == 0
                ? Optional.empty()
                : Optional.of(FenceStatus.builder()
                        .breachStatus(fence.isBreached() ? 1 : 0)
                        .breachCount(Math.min(fence.breaches(), UNKNOWN))
                        .breachType(
                                fence.isBreached() ? FenceBreach.FENCE_BREACH_BOUNDARY : FenceBreach.FENCE_BREACH_NONE)
                        .breachTime(fence.breachMs())
                        .breachMitigation(FenceMitigate.FENCE_MITIGATE_NONE)
                        .build());
    }

    static Optional<Object> home(OnboardState state, long bootMs) {
        return state.home()
                .map(at -> HomePosition.builder()
                        .latitude(whole(at.latDeg()))
                        .longitude(whole(at.lonDeg()))
                        .q(List.of(1f, 0f, 0f, 0f))
                        .approachX(Float.NaN)
                        .approachY(Float.NaN)
                        .approachZ(Float.NaN)
                        .timeUsec(micros(bootMs))
                        .build());
    }

    private static double courseDeg(double headingRad) {
        double degrees = Math.toDegrees(headingRad) % WHOLE_TURN_DEG;
        return degrees < 0 ? degrees + WHOLE_TURN_DEG : degrees;
    }

    private static int whole(double degrees) {
        return (int) Math.round(degrees * TO_WHOLE);
    }

    private static BigInteger micros(long millis) {
        return BigInteger.valueOf((long) (millis * MICROS));
    }
}
