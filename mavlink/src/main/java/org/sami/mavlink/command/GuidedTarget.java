package org.sami.mavlink.command;

import io.dronefleet.mavlink.common.MavFrame;
import io.dronefleet.mavlink.common.PositionTargetTypemask;
import io.dronefleet.mavlink.common.SetPositionTargetGlobalInt;
import io.dronefleet.mavlink.util.EnumValue;
import java.util.Objects;
import org.sami.mavlink.vehicle.VehicleId;

/** The place to which a vehicle in mode GUIDED goes; in other modes it is ignored. It is not answered, so it is sent often. Immutable. */
public record GuidedTarget(CommandPlace place) {
    private static final double TO_WHOLE = 1e7;
    private static final int POSITION_ONLY =
            0b110_111_111_000; // velocities, accelerations, yaw and its rate are to be ignored

    /** A target. */
    public GuidedTarget {
        Objects.requireNonNull(place, "place");
    }

    /** The same as a message of the library. */
    public Object message(VehicleId vehicle) {
        return SetPositionTargetGlobalInt.builder()
                .targetSystem(vehicle.system())
                .targetComponent(vehicle.component())
                .coordinateFrame(MavFrame.MAV_FRAME_GLOBAL_RELATIVE_ALT_INT)
                .typeMask(EnumValue.create(PositionTargetTypemask.class, POSITION_ONLY))
                .latInt((int) Math.round(place.latDeg() * TO_WHOLE))
                .lonInt((int) Math.round(place.lonDeg() * TO_WHOLE))
                .alt((float) place.heightM())
                .build();
    }
}
