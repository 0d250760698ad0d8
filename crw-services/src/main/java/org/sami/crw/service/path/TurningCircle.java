package org.sami.crw.service.path;

import java.util.List;
import org.sami.crw.service.LocalPlane;
import org.sami.spn.value.GeoPoint;

/**
 * What a boat drives in addition where its way turns, as it cannot turn on the spot.
 *
 * <p>It passes the corner, drives an arc of its radius, and then straight to the next corner. Against two straight legs that is {@code r (a - sin a)} more for a turn
 * by an angle {@code a}: nothing for a slight one, 0.57 r for a right angle, 3.14 r for turning back. Corners are taken to be farther apart than the circle is wide.
 *
 * <p>Source: the path of least length and bounded curvature to a point, with any heading there (L. E. Dubins, On curves of minimal length, 1957), for a point that is
 * far away.
 */
public final class TurningCircle {
    private TurningCircle() {}

    /**
     * What a turn costs in metres for each metre of radius.
     *
     * @param turnRad by how much the way turns to either side, in radians
     */
    public static double perRadius(double turnRad) {
        double turn = Math.abs(turnRad);
        return turn - StrictMath.sin(turn);
    }

    /** The same at a point of a plane, coming from one point and going on to another; 0 where two of them are one. */
    public static double perRadius(double fromX, double fromY, double x, double y, double toX, double toY) {
        double inX = x - fromX;
        double inY = y - fromY;
        double outX = toX - x;
        double outY = toY - y;
        double lengths = Math.sqrt((inX * inX + inY * inY) * (outX * outX + outY * outY));
        if (lengths == 0) {
            return 0;
        }
        double across = Math.abs(inX * outY - inY * outX);
        double turn = StrictMath.atan2(across, inX * outX + inY * outY);
        return Math.max(0, turn - across / lengths); // the sine of the turn
    }

    /** What a boat drives in addition on a way by some points, for each metre of its radius. */
    public static double perRadius(List<GeoPoint> way) {
        if (way.size() < 3) {
            return 0;
        }
        LocalPlane plane = new LocalPlane(way.get(0));
        double sum = 0;
        for (int i = 1; i + 1 < way.size(); i++) {
            GeoPoint from = way.get(i - 1);
            GeoPoint at = way.get(i);
            GeoPoint to = way.get(i + 1);
            sum += perRadius(plane.x(from), plane.y(from), plane.x(at), plane.y(at), plane.x(to), plane.y(to));
        }
        return sum;
    }
}
