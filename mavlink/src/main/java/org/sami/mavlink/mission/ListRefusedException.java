package org.sami.mavlink.mission;

import io.dronefleet.mavlink.common.MavMissionResult;
import io.dronefleet.mavlink.util.EnumValue;

/** A vehicle has refused to take, send or empty a list. The message says so in words for people. */
public final class ListRefusedException extends IllegalStateException {
    private static final long serialVersionUID = 1;
    private static final int NO_SPACE =
            EnumValue.of(MavMissionResult.MAV_MISSION_NO_SPACE).value();

    private final int result;

    /**
     * A refusal.
     *
     * @param before what stands in the message before the meaning of the result
     */
    ListRefusedException(String before, EnumValue<MavMissionResult> result) {
        super(before + MissionWords.of(result));
        this.result = result.value();
    }

    /** The vehicle's answer, a {@code MAV_MISSION_RESULT} of the protocol; newer firmwares may have numbers that no definition here has. */
    public int result() {
        return result;
    }

    /** Whether the list has more items than the vehicle has room for. */
    public boolean isOutOfSpace() {
        return result == NO_SPACE;
    }
}
