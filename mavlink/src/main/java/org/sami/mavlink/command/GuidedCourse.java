package org.sami.mavlink.command;

import io.dronefleet.mavlink.common.MavFrame;
import io.dronefleet.mavlink.common.PositionTargetTypemask;
import io.dronefleet.mavlink.common.SetPositionTargetLocalNed;
import io.dronefleet.mavlink.util.EnumValue;
import org.sami.mavlink.vehicle.VehicleId;

/**
 * Heading and speed of a boat in mode GUIDED; in other modes it is ignored. It is not answered, and ArduPilot stops the boat 3 s after the last one, so it is sent
 * several times a second.
 *
 * @param headingRad where the bow points, radians from true north clockwise
 * @param speedMps along the heading; negative is astern
 */
public record GuidedCourse(double headingRad, double speedMps) {
    private static final int HEADING_AND_SPEED =
            0b100_111_000_111; // positions, accelerations and the rate of the yaw are to be ignored

    /**
     * A course.
     *
     * @throws IllegalArgumentException if a value is not a number
     */
    public GuidedCourse {
        if (!Double.isFinite(headingRad) || !Double.isFinite(speedMps)) {
            throw new IllegalArgumentException("no course: heading " + headingRad + ", speed " + speedMps);
        }
    }

    /** The same as a message of the library. ArduPilot's boats take the speed and its sign from the first part of the velocity. */
    public Object message(VehicleId vehicle) {
        return SetPositionTargetLocalNed.builder()
                .targetSystem(vehicle.system())
                .targetComponent(vehicle.component())
                .coordinateFrame(MavFrame.MAV_FRAME_LOCAL_NED)
                .typeMask(EnumValue.create(PositionTargetTypemask.class, HEADING_AND_SPEED))
                .vx((float) speedMps)
                .yaw((float) headingRad)
                .build();
    }
}
