package org.sami.boat.server.traffic;

import org.sami.boat.server.vehicle.PlaneMath;

/** A straight segment on the plane, in metres: a stopping segment ({@link Stopping}), the edge of an area or a part of a line. */
final class Segment {
    private static final double ROUNDING_M = 1e-6; // above the rounding error of the sums here

    private final double fromEastM;
    private final double fromNorthM;
    private final double toEastM;
    private final double toNorthM;
    private final double lengthM;

    private Segment(double fromEastM, double fromNorthM, double toEastM, double toNorthM, double lengthM) {
        this.fromEastM = fromEastM;
        this.fromNorthM = fromNorthM;
        this.toEastM = toEastM;
        this.toNorthM = toNorthM;
        this.lengthM = lengthM;
    }

    /** The segment of a length from a place along a unit vector, or against it where the length is negative. */
    static Segment along(double eastM, double northM, double alongM, double east, double north) {
        return new Segment(eastM, northM, eastM + alongM * east, northM + alongM * north, Math.abs(alongM));
    }

    /** The segment between two places. */
    static Segment between(double fromEastM, double fromNorthM, double toEastM, double toNorthM) {
        return new Segment(
                fromEastM, fromNorthM, toEastM, toNorthM, PlaneMath.length(toEastM - fromEastM, toNorthM - fromNorthM));
    }

    /** The distance of a place, in metres. */
    double distanceM(double eastM, double northM) {
        return Math.sqrt(squareTo(eastM, northM));
    }

    /** Distance of a place to port of the segment's line, in metres; negative to starboard, 0 for a segment without length. */
    double portM(double eastM, double northM) {
        return lengthM > 0 ? side(eastM, northM) / lengthM : 0;
    }

    /** The point of the segment nearest to a place: 0 = its beginning, 1 = its end. */
    private double partAt(double eastM, double northM) {
        double alongEast = toEastM - fromEastM;
        double alongNorth = toNorthM - fromNorthM;
        double square = alongEast * alongEast + alongNorth * alongNorth;
        double part = square > 0 ? ((eastM - fromEastM) * alongEast + (northM - fromNorthM) * alongNorth) / square : 0;
        return Math.max(0, Math.min(1, part));
    }

    /** The course in radians from the nearest point of the segment to a place; to port where the place lies on the segment. */
    double awayRad(double eastM, double northM) {
        double part = partAt(eastM, northM);
        double offEastM = eastM - fromEastM - part * (toEastM - fromEastM);
        double offNorthM = northM - fromNorthM - part * (toNorthM - fromNorthM);
        return PlaneMath.length(offEastM, offNorthM) < ROUNDING_M
                ? StrictMath.atan2(fromNorthM - toNorthM, toEastM - fromEastM)
                : StrictMath.atan2(offEastM, offNorthM);
    }

    /** East coordinate of its end. */
    double toEastM() {
        return toEastM;
    }

    /** North coordinate of its end. */
    double toNorthM() {
        return toNorthM;
    }

    /** Distance of two segments in metres, or {@code mostM} where it is more: a quick test usually finds that. */
    double distanceM(Segment other, double mostM) {
        double eastM = other.fromEastM - fromEastM;
        double northM = other.fromNorthM - fromNorthM;
        double reachM = mostM + lengthM + other.lengthM + ROUNDING_M;
        return eastM * eastM + northM * northM > reachM * reachM ? mostM : Math.min(mostM, distanceM(other));
    }

    private double distanceM(Segment other) {
        if (crosses(other)) {
            return 0;
        }
        double mine = Math.min(squareTo(other.fromEastM, other.fromNorthM), squareTo(other.toEastM, other.toNorthM));
        double its = Math.min(other.squareTo(fromEastM, fromNorthM), other.squareTo(toEastM, toNorthM));
        return Math.sqrt(Math.min(mine, its));
    }

    private boolean crosses(Segment other) {
        return side(other.fromEastM, other.fromNorthM) * side(other.toEastM, other.toNorthM) < 0
                && other.side(fromEastM, fromNorthM) * other.side(toEastM, toNorthM) < 0;
    }

    private double side(double eastM, double northM) {
        return (toEastM - fromEastM) * (northM - fromNorthM) - (toNorthM - fromNorthM) * (eastM - fromEastM);
    }

    /** The square of the distance to a point, in m². */
    private double squareTo(double eastM, double northM) {
        double part = partAt(eastM, northM);
        double offEastM = eastM - fromEastM - part * (toEastM - fromEastM);
        double offNorthM = northM - fromNorthM - part * (toNorthM - fromNorthM);
        return offEastM * offEastM + offNorthM * offNorthM;
    }
}
