package org.sami.crw.operator.map;

import java.util.Objects;
import java.util.OptionalDouble;
import org.sami.crw.proxy.status.LinkState;
import org.sami.spn.value.GeoPoint;

/**
 * A boat on the map.
 *
 * @param position its last reported position, WGS 84
 * @param headingRad radians clockwise from true north
 * @param courseRad direction of its motion or drift, in radians clockwise from true north
 * @param speedMps along that course, negative astern
 * @param poseAtMillis time of the report on the session's clock: old values are drawn as such
 * @param batteryPercent of full; empty before the first report
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
