package org.sami.mavlink.mission;

import io.dronefleet.mavlink.common.MavMissionResult;
import io.dronefleet.mavlink.util.EnumValue;
import java.util.Locale;

/** What results of the mission protocol mean, for people. */
final class MissionWords {
    private MissionWords() {}

    static String of(EnumValue<MavMissionResult> result) {
        MavMissionResult known = result.entry();
        if (known == null) {
            return "result " + result.value();
        }
        return switch (known) {
            case MAV_MISSION_NO_SPACE -> "it holds no more items (MAV_MISSION_NO_SPACE)";
            case MAV_MISSION_DENIED ->
                "it takes none now; another ground station may be sending one (MAV_MISSION_DENIED)";
            case MAV_MISSION_ERROR -> "it is not ready; it may still be starting (MAV_MISSION_ERROR)";
            case MAV_MISSION_UNSUPPORTED -> "it cannot carry out one of the items (MAV_MISSION_UNSUPPORTED)";
            case MAV_MISSION_UNSUPPORTED_FRAME ->
                "it does not know the frame of an item (MAV_MISSION_UNSUPPORTED_FRAME)";
            case MAV_MISSION_INVALID_SEQUENCE -> "it expected another item (MAV_MISSION_INVALID_SEQUENCE)";
            default ->
                known.name()
                                .substring("MAV_MISSION_".length())
                                .toLowerCase(Locale.ROOT)
                                .replace('_', ' ') + " (" + known.name() + ")";
        };
    }
}
