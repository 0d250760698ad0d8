package org.sami.session.api;

import java.util.List;
import org.sami.crw.service.Geodesy;
import org.sami.spn.value.GeoPoint;

/**
 * The way on which an operator sends a boat to a point. Immutable.
 *
 * @param points in driving order, from the boat's position to the point, with turns around no-go areas
 * @param doubts warnings about it, as clauses; none for a safe way
 */
public record WayByHand(List<GeoPoint> points, List<String> doubts) {
    public WayByHand {
        points = List.copyOf(points);
        doubts = List.copyOf(doubts);
    }

    /** Its length in metres. */
    public double lengthM() {
        return Geodesy.lengthM(points.get(0), points.subList(1, points.size()));
    }

    /** Whether it turns on its way. */
    public boolean turns() {
        return points.size() > 2;
    }
}
