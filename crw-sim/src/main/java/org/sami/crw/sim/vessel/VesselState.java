package org.sami.crw.sim.vessel;

/**
 * Where a foreign vessel is at a moment: a rectangle along its course.
 *
 * @param eastM of its middle, metres east of the berth of the first boat
 * @param northM of its middle, metres north of it
 * @param courseRad clockwise from north
 * @param speedMps along its course
 */
public record VesselState(
        double eastM, double northM, double courseRad, double speedMps, double lengthM, double beamM) {
    /** The same on a plane whose origin lies elsewhere. */
    public VesselState movedBy(double byEastM, double byNorthM) {
        return new VesselState(eastM + byEastM, northM + byNorthM, courseRad, speedMps, lengthM, beamM);
    }

    /** Distance of a place to its hull, in metres; 0 on it. */
    public double distanceM(double atEastM, double atNorthM) {
        double sin = StrictMath.sin(courseRad);
        double cos = StrictMath.cos(courseRad);
        double byEast = atEastM - eastM;
        double byNorth = atNorthM - northM;
        double ahead = Math.max(0, Math.abs(byEast * sin + byNorth * cos) - lengthM / 2);
        double aside = Math.max(0, Math.abs(byEast * cos - byNorth * sin) - beamM / 2);
        return StrictMath.sqrt(ahead * ahead + aside * aside);
    }

    /** Of the smallest circle around its hull, in metres. */
    double radiusM() {
        return StrictMath.sqrt(lengthM * lengthM + beamM * beamM) / 2;
    }
}
