package org.sami.crw.service;

import java.util.List;
import net.sf.geographiclib.Geodesic;
import net.sf.geographiclib.GeodesicData;
import net.sf.geographiclib.GeodesicMask;
import org.sami.spn.value.GeoPoint;

/** Distances on the WGS-84 ellipsoid, in metres along the surface; altitudes are ignored, as boats are. */
public final class Geodesy {
    private Geodesy() {}

    /** Length of the shortest way between two points. */
    public static double distanceM(GeoPoint from, GeoPoint to) {
        return Geodesic.WGS84.Inverse(from.latDeg(), from.lonDeg(), to.latDeg(), to.lonDeg(), GeodesicMask.DISTANCE)
                .s12;
    }

    /** Length of a way from a point through others in their order; zero without any. */
    public static double lengthM(GeoPoint start, List<GeoPoint> points) {
        double length = 0;
        GeoPoint last = start;
        for (GeoPoint point : points) {
            length += distanceM(last, point);
            last = point;
        }
        return length;
    }

    /** The point that lies so many metres to the east and to the north of another, along one geodesic. */
    public static GeoPoint offset(GeoPoint origin, double eastM, double northM) {
        double azimuthDeg = Math.toDegrees(Math.atan2(eastM, northM));
        GeodesicData end =
                Geodesic.WGS84.Direct(origin.latDeg(), origin.lonDeg(), azimuthDeg, Math.hypot(eastM, northM));
        return new GeoPoint(end.lat2, end.lon2, origin.altM());
    }
}
