package org.sami.crw.service.coverage;

import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;

/**
 * One straight stretch of a sweep.
 *
 * @param row number of its line among the sweep's parallel lines
 * @param fromM its beginning on that line
 * @param toM its end, beyond the beginning
 * @param start the beginning as a point of the plane
 * @param end the end as a point of the plane
 */
record Lane(int row, double fromM, double toM, Coordinate start, Coordinate end) {

    /** Whether two stretches of neighbouring lines lie side by side. */
    boolean isNextTo(Lane other) {
        return fromM < other.toM && other.fromM < toM;
    }

    /** Whether it lies in a polygon, one of several in one of which it does. */
    boolean isIn(Geometry polygon, Geometry all) {
        if (all.getNumGeometries() == 1) {
            return true;
        }
        Geometry middle = all.getFactory().createPoint(new Coordinate((start.x + end.x) / 2, (start.y + end.y) / 2));
        return polygon.distance(middle) <= all.distance(middle);
    }

    double lengthM() {
        return toM - fromM;
    }
}
