package org.sami.crw.service.coverage;

import java.util.List;
import org.sami.crw.service.AreaOfTest;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.LocalPlane;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/** Plane geometry as one writes it first: what coverage is held against. Without the library that it uses. */
final class PlainGeometry {
    private final LocalPlane plane;

    /** The plane that touches at an area's first corner. */
    PlainGeometry(GeoArea area) {
        plane = new LocalPlane(area.outline().get(0));
    }

    static GeoPoint at(double eastM, double northM) {
        return Geodesy.offset(AreaOfTest.CENTRE, eastM, northM);
    }

    double[] place(GeoPoint point) {
        return new double[] {plane.x(point), plane.y(point)};
    }

    /** Whether a place lies in an area: an odd number of edges of all rings lies to the east of it. */
    boolean isIn(double[] place, GeoArea area) {
        boolean in = isIn(place, area.outline());
        for (List<GeoPoint> hole : area.holes()) {
            in ^= isIn(place, hole);
        }
        return in;
    }

    private boolean isIn(double[] place, List<GeoPoint> ring) {
        boolean in = false;
        for (int i = 0; i < ring.size(); i++) {
            double[] a = place(ring.get(i));
            double[] b = place(ring.get((i + 1) % ring.size()));
            if (a[1] > place[1] != b[1] > place[1]
                    && place[0] < a[0] + (place[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0])) {
                in = !in;
            }
        }
        return in;
    }

    /** Distance of a place to a track. */
    double distanceM(double[] place, List<GeoPoint> track) {
        double leastM = Double.POSITIVE_INFINITY;
        double[] a = place(track.get(0));
        for (GeoPoint next : track) {
            double[] b = place(next);
            leastM = Math.min(leastM, distanceM(place, a, b));
            a = b;
        }
        return leastM;
    }

    private static double distanceM(double[] p, double[] a, double[] b) {
        double dx = b[0] - a[0];
        double dy = b[1] - a[1];
        double squared = dx * dx + dy * dy;
        double t = squared == 0 ? 0 : ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / squared;
        double within = Math.max(0, Math.min(1, t));
        return Math.hypot(p[0] - a[0] - within * dx, p[1] - a[1] - within * dy);
    }
}
