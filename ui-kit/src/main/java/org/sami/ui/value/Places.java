package org.sami.ui.value;

import java.util.List;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.geo.GeoMeasure;

/** Places in words. */
final class Places {
    private Places() {}

    /** A way through points: how many and how long it is. */
    static String lengthInWords(List<GeoPoint> way) {
        String points = way.size() + (way.size() == 1 ? " point" : " points");
        return way.size() < 2 ? points : points + ", " + GeoMeasure.length(GeoMeasure.length(way));
    }
}
