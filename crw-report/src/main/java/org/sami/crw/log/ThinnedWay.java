package org.sami.crw.log;

import java.util.ArrayList;
import java.util.List;
import org.sami.crw.service.Geodesy;
import org.sami.spn.value.GeoPoint;

/** A way of bounded memory: leaves out points near the last kept one, and more of them as the way grows. */
final class ThinnedWay {
    static final int MOST_POINTS = 20_000;

    private final List<GeoPoint> kept = new ArrayList<>();
    private double stepM = 0.3;
    private GeoPoint latest;

    ThinnedWay(GeoPoint first) {
        kept.add(first);
        latest = first;
    }

    void add(GeoPoint point) {
        latest = point;
        if (Geodesy.distanceM(kept.get(kept.size() - 1), point) >= stepM) {
            kept.add(point);
        }
        if (kept.size() > MOST_POINTS) {
            thin();
        }
    }

    private void thin() {
        stepM *= 2;
        List<GeoPoint> all = List.copyOf(kept);
        kept.clear();
        kept.add(all.get(0));
        for (GeoPoint point : all) {
            if (Geodesy.distanceM(kept.get(kept.size() - 1), point) >= stepM) {
                kept.add(point);
            }
        }
        if (kept.size() > MOST_POINTS / 2) {
            thin(); // until there is room again, so that this does not happen at each point
        }
    }

    /** The points kept, and the latest. */
    List<GeoPoint> points() {
        List<GeoPoint> points = new ArrayList<>(kept);
        if (!points.get(points.size() - 1).equals(latest)) {
            points.add(latest);
        }
        return points;
    }
}
