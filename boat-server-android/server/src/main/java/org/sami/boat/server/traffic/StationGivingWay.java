package org.sami.boat.server.traffic;

import java.util.Optional;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.boat.server.vehicle.PlaneMath;
import org.sami.boat.server.vehicle.Vehicle;

/**
 * Has a boat that keeps a station give way: finds where it goes aside within its circle, so that another can come to a point on which it
 * lies. It drifts within that circle anyway.
 */
public final class StationGivingWay {
    private static final double CLEAR_M = GivingWay.APART_M + 0.5; // of the point to which the other goes
    private static final double COMING_M = 15; // who is farther from its point is not awaited yet
    private static final double HELD_UP_M = 7; // who waits farther away waits for somebody else
    private static final double FROM_EDGE_M = 0.5;
    private static final int SIDES = 24;

    private final Surroundings surroundings;
    private final Vehicle vehicle;
    private final double radiusM;
    private final double apartM;
    private Optional<String> takenBy = Optional.empty(); // who has taken the station

    /**
     * That of a boat.
     *
     * @param radiusM how far from its station it may lie
     * @param positionErrorM standard deviation of positions along each axis, the boat's own and those of others, in metres
     */
    public StationGivingWay(Surroundings surroundings, Vehicle vehicle, double radiusM, double positionErrorM) {
        this.surroundings = surroundings;
        this.vehicle = vehicle;
        this.radiusM = radiusM - FROM_EDGE_M;
        apartM = GivingWay.APART_M + GivingWay.forErrorsM(positionErrorM);
    }

    /** From now on the boat keeps another station. */
    public void begin() {
        takenBy = Optional.empty();
    }

    /**
     * Whether another boat lies still so near the station that this one cannot come to it, or lay there when it was told of last: while all lie still,
     * nothing is told.
     *
     * @param withinM how near to its station it is to come
     */
    public boolean isTaken(LocalFrame station, double withinM, long nowMs) {
        LocalFrame plane = surroundings.plane();
        double eastM = plane.eastM(station.originLatDeg(), station.originLonDeg());
        double northM = plane.northM(station.originLatDeg(), station.originLonDeg());
        for (OtherBoat other : surroundings.others()) {
            if (other.isSlow()
                    && !other.isUnderWay()
                    && PlaneMath.length(other.eastM(nowMs) - eastM, other.northM(nowMs) - northM) < apartM - withinM) {
                takenBy = Optional.of(other.boatId());
                return true;
            }
        }
        takenBy = takenBy.filter(boatId -> !surroundings.knows(boatId)); // else it has gone from there
        return takenBy.isPresent();
    }

    /** How near a boat can well come to a station that is taken, in metres. */
    public double besideTakenM() {
        return apartM + GivingWay.ROOM_M;
    }

    /** Where to go aside; empty where the boat lies in nobody's way, or there is no room. */
    public Optional<LocalFrame> aside(LocalFrame station, long nowMs) {
        if (surroundings.isEmpty()) {
            return Optional.empty();
        }
        LocalFrame plane = surroundings.plane();
        double eastM = plane.eastM(vehicle.latDeg(), vehicle.lonDeg());
        double northM = plane.northM(vehicle.latDeg(), vehicle.lonDeg());
        if (isClear(eastM, northM, nowMs)) {
            return Optional.empty();
        }
        double stationEastM = plane.eastM(station.originLatDeg(), station.originLonDeg());
        double stationNorthM = plane.northM(station.originLatDeg(), station.originLonDeg());
        double leastM = Double.MAX_VALUE;
        Optional<LocalFrame> nearest = Optional.empty();
        for (int i = 0; i < SIDES; i++) {
            double atEastM = stationEastM + radiusM * StrictMath.sin(2 * Math.PI * i / SIDES);
            double atNorthM = stationNorthM + radiusM * StrictMath.cos(2 * Math.PI * i / SIDES);
            double wayM = PlaneMath.length(atEastM - eastM, atNorthM - northM);
            if (wayM < leastM
                    && isClear(atEastM, atNorthM, nowMs)
                    && isFree(atEastM, atNorthM, nowMs)
                    && surroundings.border().allowsStraight(eastM, northM, atEastM, atNorthM)) {
                leastM = wayM;
                nearest = Optional.of(new LocalFrame(plane.latDeg(atEastM, atNorthM), plane.lonDeg(atEastM, atNorthM)));
            }
        }
        return nearest;
    }

    /** Whether nobody who comes wants to go to the station, or past it. */
    public boolean isClear(LocalFrame station, long nowMs) {
        LocalFrame plane = surroundings.plane();
        double eastM = plane.eastM(station.originLatDeg(), station.originLonDeg());
        return isClear(eastM, plane.northM(station.originLatDeg(), station.originLonDeg()), nowMs);
    }

    /** Whether nobody who comes wants to go there, and nobody waits to go past there. */
    private boolean isClear(double eastM, double northM, long nowMs) {
        for (OtherBoat other : surroundings.others()) {
            if (other.isGoing() && (isGoal(other, eastM, northM, nowMs) || isAhead(other, eastM, northM, nowMs))) {
                return false;
            }
        }
        return true;
    }

    private static boolean isGoal(OtherBoat other, double eastM, double northM, long nowMs) {
        double leftM = PlaneMath.length(other.toEastM() - other.eastM(nowMs), other.toNorthM() - other.northM(nowMs));
        return leftM < COMING_M
                && PlaneMath.length(other.toEastM() - eastM, other.toNorthM() - northM) < CLEAR_M - FROM_EDGE_M;
    }

    /** Whether a boat that hardly moves is held up by who lies there, on its straight way. */
    private static boolean isAhead(OtherBoat other, double eastM, double northM, long nowMs) {
        double awayEastM = eastM - other.eastM(nowMs);
        double awayNorthM = northM - other.northM(nowMs);
        if (!other.isSlow() || PlaneMath.length(awayEastM, awayNorthM) > HELD_UP_M) {
            return false;
        }
        double toEastM = other.toEastM() - other.eastM(nowMs);
        double toNorthM = other.toNorthM() - other.northM(nowMs);
        double wayM = PlaneMath.length(toEastM, toNorthM);
        double along = (awayEastM * toEastM + awayNorthM * toNorthM) / wayM;
        double across = Math.abs(awayEastM * toNorthM - awayNorthM * toEastM) / wayM;
        return along > 0 && along < wayM + GivingWay.APART_M && across < GivingWay.APART_M;
    }

    /** Whether nobody lies there. */
    private boolean isFree(double eastM, double northM, long nowMs) {
        for (OtherBoat other : surroundings.others()) {
            if (PlaneMath.length(other.eastM(nowMs) - eastM, other.northM(nowMs) - northM) < CLEAR_M) {
                return false;
            }
        }
        return true;
    }
}
