package org.sami.mavlink.base;

import io.dronefleet.mavlink.common.CommandAck;
import io.dronefleet.mavlink.common.MissionAck;
import io.dronefleet.mavlink.common.MissionRequest;
import io.dronefleet.mavlink.common.MissionRequestInt;
import org.sami.mavlink.link.MavlinkLink;

/**
 * For which ground station a vehicle's answers are. Commands and lists of two stations are answered by the same messages, which each of them hears. A station that
 * has the base's own ids cannot be told from it. What a vehicle holds is the same for all: an item that another station has asked for counts.
 */
final class AnswerTargets {
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

    private static boolean isAnother(int system, int component) {
        return (system != 0 && system != MavlinkLink.GROUND_SYSTEM)
                || (component != 0 && component != MavlinkLink.GROUND_COMPONENT);
    }
}
