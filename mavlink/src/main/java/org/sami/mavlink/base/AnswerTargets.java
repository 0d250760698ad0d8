package org.sami.mavlink.base;

import io.dronefleet.mavlink.common.CommandAck;
import io.dronefleet.mavlink.common.MavCmd;
import io.dronefleet.mavlink.common.MavMissionResult;
import io.dronefleet.mavlink.common.MavResult;
import io.dronefleet.mavlink.common.MissionAck;
import io.dronefleet.mavlink.common.MissionRequest;
import io.dronefleet.mavlink.common.MissionRequestInt;
import io.dronefleet.mavlink.util.EnumValue;
import java.util.OptionalInt;
import java.util.Set;
import java.util.stream.Collectors;
import org.sami.mavlink.link.MavlinkLink;

/**
 * For which ground station a vehicle's answers are. Commands and lists of two stations are answered by the same messages, which each of them hears. A station that
 * has the base's own ids cannot be told from it. What a vehicle holds is the same for all: an item that another station has asked for counts.
 */
final class AnswerTargets {
    private static final int MISSION = 0; // as against fences and rally points

    /** Commands that change what a vehicle does. */
    private static final Set<Integer> CHANGING = Set.of(
                    MavCmd.MAV_CMD_DO_SET_MODE,
                    MavCmd.MAV_CMD_COMPONENT_ARM_DISARM,
                    MavCmd.MAV_CMD_MISSION_START,
                    MavCmd.MAV_CMD_NAV_TAKEOFF,
                    MavCmd.MAV_CMD_NAV_LAND,
                    MavCmd.MAV_CMD_NAV_RETURN_TO_LAUNCH,
                    MavCmd.MAV_CMD_NAV_LOITER_UNLIM,
                    MavCmd.MAV_CMD_DO_REPOSITION,
                    MavCmd.MAV_CMD_DO_SET_MISSION_CURRENT)
            .stream()
            .map(command -> EnumValue.of(command).value())
            .collect(Collectors.toUnmodifiableSet());

    private AnswerTargets() {}

    /** Whether a message answers another ground station. One that names none, as older firmware and MAVLink 1 do, may be for the base. */
    @SuppressWarnings("deprecation") // ArduPilot still asks by the older message
    static boolean isForAnother(Object message) {
        if (message instanceof CommandAck it) {
            return isAnother(it.targetSystem(), it.targetComponent());
        } else if (message instanceof MissionAck it) {
            return isAnother(it.targetSystem(), it.targetComponent());
        } else if (message instanceof MissionRequestInt it) {
            return isAnother(it.targetSystem(), it.targetComponent());
        } else if (message instanceof MissionRequest it) {
            return isAnother(it.targetSystem(), it.targetComponent());
        }
        return false;
    }

    /** The system id of another ground station that a message tells the vehicle has obeyed: it has taken a command or a list of it. */
    static OptionalInt obeyed(Object message) {
        if (message instanceof CommandAck it
                && it.result().entry() == MavResult.MAV_RESULT_ACCEPTED
                && CHANGING.contains(it.command().value())
                && isForAnother(it)) {
            return OptionalInt.of(it.targetSystem());
        } else if (message instanceof MissionAck it
                && it.type().entry() == MavMissionResult.MAV_MISSION_ACCEPTED
                && it.missionType().value() == MISSION
                && isForAnother(it)) {
            return OptionalInt.of(it.targetSystem());
        }
        return OptionalInt.empty();
    }

    private static boolean isAnother(int system, int component) {
        return (system != 0 && system != MavlinkLink.GROUND_SYSTEM)
                || (component != 0 && component != MavlinkLink.GROUND_COMPONENT);
    }
}
