package org.sami.mavlink.mission;

import io.dronefleet.mavlink.common.MavMissionType;
import io.dronefleet.mavlink.util.EnumValue;
import java.util.Arrays;
import java.util.Optional;

/** The three lists that a vehicle holds. */
public enum HeldKind {
    /** What it does in mode AUTO, item after item. */
    MISSION("mission"),
    /** Where it must stay, and where it must not go. */
    FENCE("fence"),
    /** Where it may return to in place of home. */
    RALLY("rally points");

    private final String words;

    HeldKind(String words) {
        this.words = words;
    }

    /** Words for people. */
    public String words() {
        return words;
    }

    /** The kind that messages mean; empty where they mean all kinds, or one that is not known. */
    public static Optional<HeldKind> of(EnumValue<MavMissionType> type) {
        return Arrays.stream(values())
                .filter(kind -> kind.type() == type.entry())
                .findFirst();
    }

    /** What the library calls it. */
    public MavMissionType type() {
        return switch (this) {
            case MISSION -> MavMissionType.MAV_MISSION_TYPE_MISSION;
            case FENCE -> MavMissionType.MAV_MISSION_TYPE_FENCE;
            case RALLY -> MavMissionType.MAV_MISSION_TYPE_RALLY;
        };
    }
}
