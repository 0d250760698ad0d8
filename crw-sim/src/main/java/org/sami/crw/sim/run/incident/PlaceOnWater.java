package org.sami.crw.sim.run.incident;

import java.util.List;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.Value;

/**
 * A place that an operator gives: a point, or a square around it.
 *
 * @param eastM metres east of the centre of the area in which locations lie
 * @param northM metres north of it
 * @param sideM side of the square; 0 for a point
 * @param isQuay whether it is the quay, wherever that lies; then the other values do not count
 */
public record PlaceOnWater(double eastM, double northM, double sideM, boolean isQuay) {
    /** The quay. */
    public static final PlaceOnWater QUAY = new PlaceOnWater(0, 0, 0, true);

    /** The centre of the area in which locations lie. */
    public static final PlaceOnWater CENTRE = new PlaceOnWater(0, 0, 0, false);

    /** The value that the operator answers. */
    Value value(LocalFrame plane, GeoPoint quay) {
        if (isQuay) {
            return quay;
        }
        double half = sideM / 2;
        return sideM > 0
                ? new GeoArea(
                        List.of(
                                at(plane, -half, -half),
                                at(plane, half, -half),
                                at(plane, half, half),
                                at(plane, -half, half)),
                        List.of())
                : at(plane, 0, 0);
    }

    private GeoPoint at(LocalFrame plane, double eastwardM, double northwardM) {
        return GeoPoint.of(
                plane.latDeg(eastM + eastwardM, northM + northwardM),
                plane.lonDeg(eastM + eastwardM, northM + northwardM));
    }

    /** Whether a position is inside the square, its edge included. */
    boolean contains(double positionEastM, double positionNorthM) {
        return Math.abs(positionEastM - eastM) <= sideM / 2 && Math.abs(positionNorthM - northM) <= sideM / 2;
    }
}
