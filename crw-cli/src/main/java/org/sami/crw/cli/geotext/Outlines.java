package org.sami.crw.cli.geotext;

import java.util.List;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/** What can be measured of outlines in the plane that touches the earth at their first point. */
final class Outlines {
    private Outlines() {}

    /** Square metres inside an outline that does not cross itself. */
    static double squareMetres(GeoArea area) {
        List<GeoPoint> outline = area.outline();
        LocalFrame plane =
                new LocalFrame(outline.get(0).latDeg(), outline.get(0).lonDeg());
        double twice = 0;
        for (int i = 0; i < outline.size(); i++) {
            GeoPoint from = outline.get(i);
            GeoPoint to = outline.get((i + 1) % outline.size());
            twice += eastM(plane, from) * northM(plane, to) - eastM(plane, to) * northM(plane, from);
        }
        return Math.abs(twice) / 2;
    }

    private static double eastM(LocalFrame plane, GeoPoint point) {
        return plane.eastM(point.latDeg(), point.lonDeg());
    }

    private static double northM(LocalFrame plane, GeoPoint point) {
        return plane.northM(point.latDeg(), point.lonDeg());
    }
}
