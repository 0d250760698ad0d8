package org.sami.mavlink.onboard;

import io.dronefleet.mavlink.common.AutopilotVersion;
import io.dronefleet.mavlink.common.MavProtocolCapability;
import io.dronefleet.mavlink.common.MavSysStatusSensor;
import io.dronefleet.mavlink.common.SysStatus;
import io.dronefleet.mavlink.minimal.ProtocolVersion;
import java.math.BigInteger;
import java.util.ArrayList;
import java.util.List;

/** Writes what a boat is and can: its version, its protocol, its parts. */
@SuppressWarnings({"rawtypes", "deprecation"
}) // the library takes flags as plain enums; stations that are older look for what is deprecated
final class OnboardIdentity {
    private static final long VERSION = 1L << 24; // 1.0.0, of this end of the protocol; it is no version of ArduPilot's
    private static final int MAVLINK_2 = 200;
    private static final int UID_BYTES = 18;
    private static final int HASH_BYTES = 8;
    private static final int UNKNOWN = 0xffff;
    private static final List<Enum> PARTS = List.of(
            MavSysStatusSensor.MAV_SYS_STATUS_SENSOR_3D_MAG,
            MavSysStatusSensor.MAV_SYS_STATUS_SENSOR_GPS,
            MavSysStatusSensor.MAV_SYS_STATUS_SENSOR_MOTOR_OUTPUTS,
            MavSysStatusSensor.MAV_SYS_STATUS_SENSOR_BATTERY,
            MavSysStatusSensor.MAV_SYS_STATUS_PREARM_CHECK);

    private OnboardIdentity() {}

    /** Its parts are those of which a boat's server knows whether they work. */
    static Object status(OnboardState state) {
        List<Enum> present = new ArrayList<>(PARTS);
        List<Enum> enabled = new ArrayList<>(PARTS);
        List<Enum> working = new ArrayList<>(List.of(MavSysStatusSensor.MAV_SYS_STATUS_SENSOR_MOTOR_OUTPUTS));
        if (state.fence().isHeld()) {
            present.add(MavSysStatusSensor.MAV_SYS_STATUS_GEOFENCE);
        }
        if (state.fence().isInForce()) {
            enabled.add(MavSysStatusSensor.MAV_SYS_STATUS_GEOFENCE);
        }
        if (!state.fence().isBreached()) { // also without a fence: MAVProxy would say that it is breached
            working.add(MavSysStatusSensor.MAV_SYS_STATUS_GEOFENCE);
        }
        if (state.place().isPresent()) {
            working.add(MavSysStatusSensor.MAV_SYS_STATUS_SENSOR_3D_MAG);
            working.add(MavSysStatusSensor.MAV_SYS_STATUS_SENSOR_GPS);
            working.add(MavSysStatusSensor.MAV_SYS_STATUS_PREARM_CHECK);
        }
        if (state.batteryState() != OnboardState.BatteryState.CRITICAL) {
            working.add(MavSysStatusSensor.MAV_SYS_STATUS_SENSOR_BATTERY);
        }
        return SysStatus.builder()
                .onboardControlSensorsPresent(present)
                .onboardControlSensorsEnabled(enabled)
                .onboardControlSensorsHealth(working)
                .voltageBattery(UNKNOWN)
                .currentBattery(-1)
                .batteryRemaining(OnboardReports.percent(state))
                .build();
    }

    /** @param name by which its unique number is made, equal at each start */
    static Object version(String name) {
        return AutopilotVersion.builder()
                .capabilities(
                        MavProtocolCapability.MAV_PROTOCOL_CAPABILITY_MISSION_INT,
                        MavProtocolCapability.MAV_PROTOCOL_CAPABILITY_MISSION_FENCE,
                        MavProtocolCapability.MAV_PROTOCOL_CAPABILITY_COMMAND_INT,
                        MavProtocolCapability.MAV_PROTOCOL_CAPABILITY_PARAM_FLOAT,
                        MavProtocolCapability.MAV_PROTOCOL_CAPABILITY_SET_POSITION_TARGET_GLOBAL_INT,
                        MavProtocolCapability.MAV_PROTOCOL_CAPABILITY_MAVLINK2)
                .flightSwVersion(VERSION)
                .flightCustomVersion(new byte[HASH_BYTES])
                .middlewareCustomVersion(new byte[HASH_BYTES])
                .osCustomVersion(new byte[HASH_BYTES])
                .uid(BigInteger.valueOf(Integer.toUnsignedLong(name.hashCode())))
                .uid2(new byte[UID_BYTES])
                .build();
    }

    static Object protocol() {
        return ProtocolVersion.builder()
                .version(MAVLINK_2)
                .minVersion(MAVLINK_2)
                .maxVersion(MAVLINK_2)
                .specVersionHash(new byte[HASH_BYTES])
                .libraryVersionHash(new byte[HASH_BYTES])
                .build();
    }
}
