package org.sami.crw.log;

import java.util.List;
import org.sami.spn.value.GeoPoint;

/**
 * A piece of a track in which every position can have been reached from the one before it.
 *
 * @param number from 1, in the order of the log
 * @param firstLine where it begins in the file
 * @param startMillis since the log's first entry
 * @param endMillis since the log's first entry
 * @param positions how many were logged
 * @param distanceM metres along all logged positions
 * @param points the way, thinned for drawing: the first, the last, and what is some decimetres apart or more
 */
public record TrackSegment(
        int number,
        long firstLine,
        long startMillis,
        long endMillis,
        long positions,
        double distanceM,
        List<GeoPoint> points) {
    public TrackSegment {
        points = List.copyOf(points);
        if (points.isEmpty()) {
            throw new IllegalArgumentException("a stretch has a point");
        }
    }

    GeoPoint first() {
        return points.get(0);
    }

    GeoPoint last() {
        return points.get(points.size() - 1);
    }
}
