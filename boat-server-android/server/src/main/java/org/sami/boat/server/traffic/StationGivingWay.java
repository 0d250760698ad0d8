package org.sami.boat.server.traffic;

import java.util.Optional;
import org.sami.boat.server.vehicle.Kinematics;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.boat.server.vehicle.PlaneMath;

/**
 * Makes a boat that keeps a station give way: finds a place within its circle to which it moves aside, so that another boat reaches the point where
 * it lies. It drifts within that circle anyway.
 */
public final class StationGivingWay {
    private static final double CLEARANCE_M = GivingWay.APART_M + 0.5; // from the point to which the other goes
    private static final double APPROACH_M = 15; // a boat farther from its point is not approaching yet
    private static final double BLOCKED_WITHIN_M = 7; // a boat that waits farther away waits for another one
    private static final double CIRCLE_MARGIN_M = 0.5;
    private static final int SIDES = 24;

    private final Surroundings surroundings;
    private final Kinematics vehicle;
    private final double radiusM;
    private final double apartM;
    private final double marginM; // kept in addition from where others pass
    private Optional<String> takenBy = Optional.empty(); // the boat on the station

    /**
     * For one boat.
     *
     * @param radiusM how far from its station the boat may lie, in metres
     * @param positionErrorM standard deviation of positions along each axis, the boat's own and those of others, in metres
     */
    public StationGivingWay(Surroundings surroundings, Kinematics vehicle, double radiusM, double positionErrorM) {
        this(surroundings, vehicle, radiusM, positionErrorM, 0);
    }

    private StationGivingWay(
            Surroundings surroundings, Kinematics vehicle, double radiusM, double positionErrorM, double marginM) {
        this.marginM = marginM;
        this.surroundings = surroundings;
        this.vehicle = vehicle;
        this.radiusM = radiusM - CIRCLE_MARGIN_M;
        apartM = GivingWay.APART_M + GivingWay.errorMarginM(positionErrorM);
    }

    /** The same for one that makes as much more room as boats of these position errors keep from it in passing. */
    public static StationGivingWay wide(
            Surroundings surroundings, Kinematics vehicle, double radiusM, double positionErrorM) {
        return new StationGivingWay(
                surroundings, vehicle, radiusM, positionErrorM, GivingWay.errorMarginM(positionErrorM));
    }

    /** The boat keeps another station from now on. */
    public void begin() {
        takenBy = Optional.empty();
    }

    /**
     * Whether another boat lies still so close to the station that this one cannot reach it. The last report counts: boats that lie still send none.
     *
     * @param withinM how close to its station this boat has to come, in metres
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
        takenBy = takenBy.filter(boatId -> !surroundings.knows(boatId)); // a newer report has it elsewhere
        return takenBy.isPresent();
    }

    /** Distance at which a boat can lie next to a station that is taken, in metres. */
    public double nextToTakenM() {
        return apartM + GivingWay.PASSING_CLEARANCE_M;
    }

    /** Where to move aside; empty where the boat is in nobody's way, or there is no room. */
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

    /** Whether no approaching boat is heading for the station or past it. */
    public boolean isClear(LocalFrame station, long nowMs) {
        LocalFrame plane = surroundings.plane();
        double eastM = plane.eastM(station.originLatDeg(), station.originLonDeg());
        return isClear(eastM, plane.northM(station.originLatDeg(), station.originLonDeg()), nowMs);
    }

    /** Whether no approaching boat is heading for a place, and none waits to pass it. */
    private boolean isClear(double eastM, double northM, long nowMs) {
        for (OtherBoat other : surroundings.others()) {
            if (other.isGoing() && (isGoal(other, eastM, northM, nowMs) || isAhead(other, eastM, northM, nowMs))) {
                return false;
            }
        }
        return true;
    }

    private boolean isGoal(OtherBoat other, double eastM, double northM, long nowMs) {
        double leftM = PlaneMath.length(other.toEastM() - other.eastM(nowMs), other.toNorthM() - other.northM(nowMs));
        return leftM < APPROACH_M
                && PlaneMath.length(other.toEastM() - eastM, other.toNorthM() - northM)
                        < CLEARANCE_M - CIRCLE_MARGIN_M + marginM;
    }

    /** Whether a boat lying at a place blocks the straight way of another one that hardly moves. */
    private boolean isAhead(OtherBoat other, double eastM, double northM, long nowMs) {
        double awayEastM = eastM - other.eastM(nowMs);
        double awayNorthM = northM - other.northM(nowMs);
        if (!other.isSlow() || PlaneMath.length(awayEastM, awayNorthM) > BLOCKED_WITHIN_M) {
            return false;
        }
        double toEastM = other.toEastM() - other.eastM(nowMs);
        double toNorthM = other.toNorthM() - other.northM(nowMs);
        double wayM = PlaneMath.length(toEastM, toNorthM);
        double along = (awayEastM * toEastM + awayNorthM * toNorthM) / wayM;
        double across = Math.abs(awayEastM * toNorthM - awayNorthM * toEastM) / wayM;
        return along > 0 && along < wayM + GivingWay.APART_M && across < GivingWay.APART_M + marginM;
    }

    /** Whether no boat is near a place. */
    private boolean isFree(double eastM, double northM, long nowMs) {
        for (OtherBoat other : surroundings.others()) {
            if (PlaneMath.length(other.eastM(nowMs) - eastM, other.northM(nowMs) - northM) < CLEARANCE_M) {
                return false;
            }
        }
        return true;
    }
}
