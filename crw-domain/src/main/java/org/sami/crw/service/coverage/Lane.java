package org.sami.crw.service.coverage;

import org.locationtech.jts.geom.Coordinate;

/**
 * One straight stretch of a sweep.
 *
 * @param row the number of its line among the sweep's parallel lines
 * @param fromM where on its line it begins
 * @param toM where it ends, more than that
 * @param start the same as a place on the plane
 * @param end the same as a place on the plane
 */
record Lane(int row, double fromM, double toM, Coordinate start, Coordinate end) {

    /** Whether two stretches of neighbouring lines lie side by side. */
    boolean isBeside(Lane other) {
        return fromM < other.toM && other.fromM < toM;
    }

    double lengthM() {
        return toM - fromM;
    }
}
