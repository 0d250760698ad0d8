package org.sami.boat.server.traffic;

import org.sami.boat.server.vehicle.PlaneMath;

/**
 * The way on which a boat that begins to stop now comes to rest: straight on, some of it before it stops at all. Likewise any other straight piece of
 * the plane that is to be measured against such ways.
 */
final class StoppingWay {
    /** Until what is decided shows, and others know of it. */
    static final double REACTION_S = 0.3;

    /** How fast small hulls stop with motors astern, in m/s per second. */
    static final double BRAKING_MPS2 = 0.5;

    private static final double SLACK_M = 1e-6; // more than sums are rounded by

    private final double fromEastM;
    private final double fromNorthM;
    private final double toEastM;
    private final double toNorthM;
    private final double lengthM;

    private StoppingWay(double fromEastM, double fromNorthM, double toEastM, double toNorthM, double lengthM) {
        this.fromEastM = fromEastM;
        this.fromNorthM = fromNorthM;
        this.toEastM = toEastM;
        this.toNorthM = toNorthM;
        this.lengthM = lengthM;
    }

    /** The way of a boat that is here, with that heading and speed; of a negative speed astern. */
    static StoppingWay of(double eastM, double northM, Course heading, double speedMps, double reactionS) {
        return along(eastM, northM, lengthM(speedMps, reactionS), heading.east(), heading.north());
    }

    /** A way of that length in the direction of a unit vector; of a negative length against it. */
    static StoppingWay along(double eastM, double northM, double alongM, double east, double north) {
        return new StoppingWay(eastM, northM, eastM + alongM * east, northM + alongM * north, Math.abs(alongM));
    }

    /** The straight piece between two places. */
    static StoppingWay between(double fromEastM, double fromNorthM, double toEastM, double toNorthM) {
        return new StoppingWay(
                fromEastM, fromNorthM, toEastM, toNorthM, PlaneMath.length(toEastM - fromEastM, toNorthM - fromNorthM));
    }

    /** Where it ends. */
    double toEastM() {
        return toEastM;
    }

    /** Where it ends. */
    double toNorthM() {
        return toNorthM;
    }

    /** How long such a way is, in metres; negative astern. */
    static double lengthM(double speedMps, double reactionS) {
        return speedMps * reactionS + speedMps * Math.abs(speedMps) / (2 * BRAKING_MPS2);
    }

    /**
     * The least distance of two ways, whenever boats are where on them, in metres; no more than {@code mostM}. Where the beginnings and lengths of the
     * ways say that it is more, it is not computed.
     */
    double distanceM(StoppingWay other, double mostM) {
        double eastM = other.fromEastM - fromEastM;
        double northM = other.fromNorthM - fromNorthM;
        double reachM = mostM + lengthM + other.lengthM + SLACK_M;
        return eastM * eastM + northM * northM > reachM * reachM ? mostM : Math.min(mostM, distanceM(other));
    }

    /** The least distance of two ways, whenever boats are where on them; in metres. */
    private double distanceM(StoppingWay other) {
        if (crosses(other)) {
            return 0;
        }
        double mine = Math.min(squareTo(other.fromEastM, other.fromNorthM), squareTo(other.toEastM, other.toNorthM));
        double its = Math.min(other.squareTo(fromEastM, fromNorthM), other.squareTo(toEastM, toNorthM));
        return Math.sqrt(Math.min(mine, its));
    }

    private boolean crosses(StoppingWay other) {
        return side(other.fromEastM, other.fromNorthM) * side(other.toEastM, other.toNorthM) < 0
                && other.side(fromEastM, fromNorthM) * other.side(toEastM, toNorthM) < 0;
    }

    private double side(double eastM, double northM) {
        return (toEastM - fromEastM) * (northM - fromNorthM) - (toNorthM - fromNorthM) * (eastM - fromEastM);
    }

    /** The square of the distance to a point, in m². */
    private double squareTo(double eastM, double northM) {
        double alongEast = toEastM - fromEastM;
        double alongNorth = toNorthM - fromNorthM;
        double square = alongEast * alongEast + alongNorth * alongNorth;
        double part = square > 0 ? ((eastM - fromEastM) * alongEast + (northM - fromNorthM) * alongNorth) / square : 0;
        double within = Math.max(0, Math.min(1, part));
        double offEastM = eastM - fromEastM - within * alongEast;
        double offNorthM = northM - fromNorthM - within * alongNorth;
        return offEastM * offEastM + offNorthM * offNorthM;
    }
}
