package org.sami.crw.sim.picture;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.spn.value.GeoPoint;

/**
 * Something that floats at a fixed place of the simulated water.
 *
 * @param kind what it is
 * @param at where it floats
 */
record FloatingObject(Kind kind, GeoPoint at) {
    private static final double CELL_M = 45;
    private static final double SHARE = 0.5; // of the cells hold something
    private static final double M_PER_DEG = 111_320;

    /** What floats, with its size in metres. */
    enum Kind {
        RED_BUOY(0.7, 1.3),
        YELLOW_BUOY(0.6, 1.0),
        BARREL(0.9, 0.55),
        DRIFTWOOD(2.6, 0.3);

        final double widthM;
        final double heightM;

        Kind(double widthM, double heightM) {
            this.widthM = widthM;
            this.heightM = heightM;
        }
    }

    /** What floats within a distance of a place; the same for every boat of a water. */
    static List<FloatingObject> near(LocalFrame place, double withinM, long seed) {
        double lat0 = place.originLatDeg();
        double cellLatDeg = CELL_M / M_PER_DEG;
        long row0 = (long) Math.floor(lat0 / cellLatDeg);
        int around = (int) Math.ceil(withinM / CELL_M) + 1;
        List<FloatingObject> near = new ArrayList<>();
        for (long row = row0 - around; row <= row0 + around; row++) {
            double latDeg = row * cellLatDeg;
            double cellLonDeg = cellLatDeg / Math.max(0.05, StrictMath.cos(Math.toRadians(latDeg)));
            long column0 = (long) Math.floor(place.originLonDeg() / cellLonDeg);
            for (long column = column0 - around; column <= column0 + around; column++) {
                SplittableRandom random = new SplittableRandom(seed * 31 + row * 1_000_003 + column * 7_919);
                boolean there = random.nextDouble() < SHARE;
                Kind kind = Kind.values()[random.nextInt(Kind.values().length)];
                double objectLat = latDeg + random.nextDouble() * cellLatDeg;
                double objectLon = (column + random.nextDouble()) * cellLonDeg;
                boolean onGlobe = Math.abs(objectLat) <= 89 && Math.abs(objectLon) <= 180;
                if (there && onGlobe && place.distanceM(objectLat, objectLon) <= withinM) {
                    near.add(new FloatingObject(kind, GeoPoint.of(objectLat, objectLon)));
                }
            }
        }
        return near;
    }
}
