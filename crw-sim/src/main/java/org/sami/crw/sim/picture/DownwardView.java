package org.sami.crw.sim.picture;

import java.util.Optional;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.spn.value.GeoPoint;

/** Where things stand in a picture that is taken straight down: a pinhole camera whose upper edge points along the heading. */
final class DownwardView {
    private static final double NEAREST_M = 0.5;
    private static final double HALF_WIDTH =
            0.7; // of the picture, as a part of the height: the lens of the detector of targets

    private final LocalFrame eye;
    private final double heightM;
    private final double headingRad;

    DownwardView(GeoPoint eye, double headingRad) {
        this.eye = new LocalFrame(eye.latDeg(), eye.lonDeg());
        heightM = eye.altM();
        this.headingRad = headingRad;
    }

    LocalFrame eye() {
        return eye;
    }

    /** Clockwise from true north. */
    double headingRad() {
        return headingRad;
    }

    /** Pixels of one metre on the water. */
    double waterScale() {
        return scale(heightM);
    }

    /** How far from the middle of the picture things on the water are seen. */
    double seenM() {
        return StrictMath.hypot(Perspective.WIDTH, Perspective.HEIGHT) / 2 / waterScale();
    }

    /** Where a place stands, with its own height; empty for what is as high as the camera, or higher. */
    Optional<Spot> spot(GeoPoint place) {
        double below = heightM - place.altM();
        if (below < NEAREST_M) {
            return Optional.empty();
        }
        double east = eye.eastM(place.latDeg(), place.lonDeg());
        double north = eye.northM(place.latDeg(), place.lonDeg());
        double ahead = east * StrictMath.sin(headingRad) + north * StrictMath.cos(headingRad);
        double right = east * StrictMath.cos(headingRad) - north * StrictMath.sin(headingRad);
        double scale = scale(below);
        return Optional.of(
                new Spot(Perspective.WIDTH / 2.0 + right * scale, Perspective.HEIGHT / 2.0 - ahead * scale, scale));
    }

    private static double scale(double belowM) {
        return Perspective.WIDTH / (2 * belowM * HALF_WIDTH);
    }

    /**
     * A place in the picture.
     *
     * @param scale pixels of one metre there
     */
    record Spot(double x, double y, double scale) {
        /** Whether something is seen whose parts are at most so far from the place. */
        boolean isSeen(double reachM) {
            double px = reachM * scale;
            return x > -px && x < Perspective.WIDTH + px && y > -px && y < Perspective.HEIGHT + px;
        }
    }
}
