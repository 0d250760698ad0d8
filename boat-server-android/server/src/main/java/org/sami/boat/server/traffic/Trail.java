package org.sami.boat.server.traffic;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.boat.server.vehicle.PlaneMath;

/** The last 200 m or so of the way on which a boat came, for backing up. */
final class Trail {
    private static final double STEP_DEG = 2e-5; // some 2 m
    private static final int MOST_PLACES = 100;
    private static final double PASSED_M = 2;
    private static final double CORNER_REACHED_M = 0.7; // where the boat may not cut the corner

    private final Deque<double[]> places = new ArrayDeque<>(); // latitude and longitude in degrees, newest first
    // copy of the newest for the test in each tick; NaN where there is none
    private double newestLatDeg = Double.NaN;
    private double newestLonDeg = Double.NaN;

    /** Adds a place if it is some metres from the last one. */
    void add(double latDeg, double lonDeg) {
        boolean isThere = Math.abs(latDeg - newestLatDeg) <= STEP_DEG && Math.abs(lonDeg - newestLonDeg) <= STEP_DEG;
        if (!isThere) {
            addFirst(new double[] {latDeg, lonDeg});
            if (places.size() > MOST_PLACES) {
                places.removeLast();
            }
        }
    }

    private void addFirst(double[] place) {
        places.addFirst(place);
        newestLatDeg = place[0];
        newestLonDeg = place[1];
    }

    /**
     * The line to the place before. Places that the boat has come back to are dropped, at a corner only once it has reached them. Empty at the end of the
     * trail.
     */
    Optional<LineAhead> back(Surroundings surroundings, double eastM, double northM) {
        LocalFrame plane = surroundings.plane();
        while (!places.isEmpty()) {
            double[] place = places.removeFirst();
            double toEastM = plane.eastM(place[0], place[1]) - eastM;
            double toNorthM = plane.northM(place[0], place[1]) - northM;
            double lengthM = PlaneMath.length(toEastM, toNorthM);
            if (lengthM > PASSED_M || (lengthM > CORNER_REACHED_M && isNextBarred(surroundings, eastM, northM))) {
                addFirst(place);
                return Optional.of(LineAhead.straight(StrictMath.atan2(toEastM, toNorthM), lengthM));
            }
        }
        newestLatDeg = Double.NaN;
        newestLonDeg = Double.NaN;
        return Optional.empty();
    }

    private boolean isNextBarred(Surroundings surroundings, double eastM, double northM) {
        double[] next = places.peekFirst();
        LocalFrame plane = surroundings.plane();
        return next != null
                && surroundings
                        .border()
                        .bars(eastM, northM, plane.eastM(next[0], next[1]), plane.northM(next[0], next[1]));
    }
}
