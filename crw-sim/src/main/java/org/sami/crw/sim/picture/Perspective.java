package org.sami.crw.sim.picture;

import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.boat.server.vehicle.PlaneMath;
import org.sami.spn.value.GeoPoint;

/** Where things of the water stand in a picture: a pinhole camera that looks level ahead. */
final class Perspective {
    static final int WIDTH = 640;
    static final int HEIGHT = 360;
    static final int HORIZON_Y = 150;

    /** What the camera sees from the left edge to the right one. */
    static final double FIELD_OF_VIEW_RAD = Math.toRadians(60);

    private static final double CAMERA_HEIGHT_M = 0.9;
    private static final double FOCAL_PX = WIDTH / 2.0 / StrictMath.tan(FIELD_OF_VIEW_RAD / 2);

    private final LocalFrame eye;
    private final double headingRad;

    Perspective(GeoPoint eye, double headingRad) {
        this.eye = new LocalFrame(eye.latDeg(), eye.lonDeg());
        this.headingRad = headingRad;
    }

    LocalFrame eye() {
        return eye;
    }

    /** A place on the water: how far ahead it is, and where it stands in the picture. */
    Spot spot(GeoPoint place) {
        double east = eye.eastM(place.latDeg(), place.lonDeg());
        double north = eye.northM(place.latDeg(), place.lonDeg());
        double ahead = east * StrictMath.sin(headingRad) + north * StrictMath.cos(headingRad);
        double right = east * StrictMath.cos(headingRad) - north * StrictMath.sin(headingRad);
        double scale = FOCAL_PX / Math.max(0.1, ahead);
        return new Spot(ahead, WIDTH / 2.0 + right * scale, HORIZON_Y + CAMERA_HEIGHT_M * scale, scale);
    }

    /** Where a bearing stands, from -1 rad off the heading to 1 rad; far outside the picture for what lies behind. */
    double x(double bearingRad) {
        double off = PlaneMath.sameTurn(bearingRad - headingRad);
        return Math.abs(off) > 1.2 ? -10_000 : WIDTH / 2.0 + FOCAL_PX * StrictMath.tan(off);
    }

    /** The bearing of a column of the picture. */
    double bearingRad(double x) {
        return headingRad + StrictMath.atan((x - WIDTH / 2.0) / FOCAL_PX);
    }

    /**
     * A place in the picture.
     *
     * @param aheadM how far before the camera
     * @param scale pixels of one metre there
     */
    record Spot(double aheadM, double x, double y, double scale) {
        /** Whether something so wide is seen. */
        boolean isSeen(double widthM) {
            double half = widthM * scale / 2;
            return aheadM > 0.8 && x + half > 0 && x - half < WIDTH;
        }
    }
}
