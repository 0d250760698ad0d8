package org.sami.crw.service.coverage;

import java.util.List;
import org.locationtech.jts.geom.Coordinate;

/** The direction along which tracks lead for most of their length, to and fro being the same. */
final class MeanAxis {
    private MeanAxis() {}

    /**
     * The mean direction of all legs by their lengths; one across to others takes away from them and does not turn them. Doubled angles make to and fro
     * equal (K. V. Mardia, P. E. Jupp, Directional Statistics, 2000, 1.1).
     *
     * @return in radians from the x-axis to the y-axis, from -π/2 to π/2; 0 where no leg has a length
     */
    static double ofRad(List<List<Coordinate>> tracks) {
        double alongX = 0;
        double alongY = 0;
        for (List<Coordinate> track : tracks) {
            for (int i = 1; i < track.size(); i++) {
                double dx = track.get(i).x - track.get(i - 1).x;
                double dy = track.get(i).y - track.get(i - 1).y;
                double lengthM = Math.hypot(dx, dy);
                if (lengthM > 0) {
                    alongX += (dx * dx - dy * dy) / lengthM;
                    alongY += 2 * dx * dy / lengthM;
                }
            }
        }
        return Math.atan2(alongY, alongX) / 2;
    }
}
