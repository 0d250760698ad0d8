package org.sami.ui.value;

import java.util.List;
import java.util.Optional;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.geo.GeoMeasure;

/** Places in words. */
final class Places {
    private Places() {}

    /**
     * A path: how many points it has, and how long the way along it is.
     *
     * @param way on which its robot would go, from where it is; where that is not known, the way from the first point on is named as that
     */
    static String pathInWords(GeoPath path, Optional<List<GeoPoint>> way) {
        int count = path.points().size();
        String points = count + (count == 1 ? " point" : " points");
        if (way.isPresent()) {
            return points + ", " + GeoMeasure.length(GeoMeasure.length(way.get())) + " from where it is";
        }
        return count < 2
                ? points
                : points + ", " + GeoMeasure.length(GeoMeasure.length(path.points())) + " from the first on";
    }
}
