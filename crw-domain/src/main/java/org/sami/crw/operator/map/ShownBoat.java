package org.sami.crw.operator.map;

import java.util.Objects;
import java.util.OptionalDouble;
import org.sami.crw.proxy.status.LinkState;
import org.sami.spn.value.GeoPoint;

/**
 * A boat on the map.
 *
 * @param position where it said it was last, WGS 84
 * @param headingRad radians clockwise from true north
 * @param courseRad where it goes, or is carried to, in radians clockwise from true north
 * @param speedMps along that course, negative astern
 * @param poseAtMillis when it said so, on the session's clock: what is old is to be drawn as such
 * @param batteryPercent of full; empty before it was told
 * @param highlighted whether a markup or a person points at it
 */
public record ShownBoat(
        String boat,
        GeoPoint position,
        double headingRad,
        double courseRad,
        double speedMps,
        long poseAtMillis,
        OptionalDouble batteryPercent,
        LinkState link,
        boolean highlighted) {
    /** Whether it goes elsewhere than where it heads, as it does not drive. */
    public boolean isCarried() {
        return courseRad != headingRad;
    }

    public ShownBoat {
        Objects.requireNonNull(boat, "boat");
        Objects.requireNonNull(position, "position");
        Objects.requireNonNull(batteryPercent, "batteryPercent");
        Objects.requireNonNull(link, "link");
    }
}
