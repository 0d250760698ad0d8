package org.sami.boat.server.traffic;

import java.util.Optional;
import org.sami.boat.server.vehicle.PlaneMath;

/**
 * Finds where a boat goes back to when another one comes towards it and what is not to be entered leaves no room to pass: as it came, until there is
 * room aside, and there it waits until the other one is past. Who has no right of way goes back first. Likewise a boat goes back that has got where
 * its line is out of sight, and one makes room that has stood long beside another one with the right of way.
 */
final class GoingBack {
    private static final double STOOD_S = 6;
    private static final double STOOD_FIRST_S = 30; // who goes first goes back too where the other one cannot
    private static final double STOOD_BESIDE_S = 12; // likewise beside another one that stands and has the right of way
    private static final double AWAY_M = 3; // so far at a time a boat makes room for that one
    private static final double[] AWAY_DEG = {0, 45, -45, 90, -90};
    private static final long LONGEST_WAIT_MS = 20_000; // who is not past by then waits too
    private static final double NEAR_M = 10;
    private static final double FORGOTTEN_M = 30;
    private static final double PASSED_M = 2;
    private static final double TOWARDS = 0.5; // cosine of what is still towards something
    private static final double ENOUGH = 0.95; // of the room that is to be made
    private static final LineAhead STAY = LineAhead.straight(0, 0);

    private final Surroundings surroundings;
    private final double roomM;
    private final Trail trail = new Trail();
    private String fromId = ""; // the boat from which it goes back
    private boolean makesRoom; // for that boat, which does not come towards it
    private boolean returns; // to where it sees its line
    private long waitsSinceMs = Long.MAX_VALUE;

    /**
     * Nobody comes.
     *
     * @param roomM how far from the other's course is room enough, in metres
     */
    GoingBack(Surroundings surroundings, double roomM) {
        this.surroundings = surroundings;
        this.roomM = roomM;
    }

    /** Records where the boat is on its way. */
    void record(double latDeg, double lonDeg) {
        trail.add(latDeg, lonDeg);
    }

    void end() {
        fromId = "";
        makesRoom = false;
        returns = false;
        waitsSinceMs = Long.MAX_VALUE;
    }

    /**
     * The line on which to go back now, which has no length where the boat is to stay; empty where it does not go back.
     *
     * @param wantedRad the course on which it would go without others
     * @param stoodS for how long it has come no farther, in seconds
     * @param isBarred whether what is not to be entered lies between it and its line
     */
    Optional<LineAhead> way(
            double eastM, double northM, double wantedRad, double stoodS, boolean isBarred, long nowMs) {
        Optional<OtherBoat> coming = coming(eastM, northM, wantedRad, stoodS, nowMs);
        if (fromId.isEmpty()) {
            makesRoom = coming.isPresent() && isToMakeRoom(coming.get(), stoodS);
        }
        fromId = coming.isPresent() ? coming.get().boatId() : "";
        if (!coming.isPresent()) {
            makesRoom = false;
            returns = isBarred && (returns || stoodS >= STOOD_S);
            return returns ? trail.back(surroundings, eastM, northM) : Optional.empty();
        }
        LineAhead back =
                makesRoom ? away(coming.get(), eastM, northM, nowMs) : back(coming.get(), eastM, northM, nowMs);
        waitsSinceMs = back == STAY ? Math.min(waitsSinceMs, nowMs) : Long.MAX_VALUE;
        if (back == STAY && nowMs - waitsSinceMs > LONGEST_WAIT_MS) {
            end();
            return Optional.empty();
        }
        return Optional.of(back);
    }

    private Optional<OtherBoat> coming(double eastM, double northM, double wantedRad, double stoodS, long nowMs) {
        if (fromId.isEmpty() && stoodS < STOOD_S) {
            return Optional.empty(); // most of the time: nobody goes back so soon
        }
        for (OtherBoat other : surroundings.others()) {
            boolean isComing = fromId.isEmpty()
                    ? isMet(other, eastM, northM, wantedRad, stoodS, nowMs)
                    : other.boatId().equals(fromId) && isStillComing(other, eastM, northM, nowMs);
            if (isComing) {
                return Optional.of(other);
            }
        }
        return Optional.empty();
    }

    /** Whether the two stand before each other, and this one is to go back. */
    private boolean isMet(OtherBoat other, double eastM, double northM, double wantedRad, double stoodS, long nowMs) {
        boolean isFirst = surroundings.ownId().compareTo(other.boatId()) < 0;
        if (stoodS < (isFirst ? STOOD_FIRST_S : STOOD_S)
                || !other.isUnderWay()
                || surroundings.border().isEmpty()) {
            return false;
        }
        double toEastM = other.eastM(nowMs) - eastM;
        double toNorthM = other.northM(nowMs) - northM;
        double awayM = PlaneMath.length(toEastM, toNorthM);
        if (awayM >= NEAR_M) {
            return false;
        }
        double onMyWayM = toEastM * StrictMath.sin(wantedRad) + toNorthM * StrictMath.cos(wantedRad);
        return isToMakeRoom(other, stoodS)
                || (onMyWayM > TOWARDS * awayM && isAhead(other, eastM, northM, TOWARDS * awayM, nowMs));
    }

    /** Whether this boat is to make room for another one that has the right of way and stands as well, whether it comes or not. */
    private boolean isToMakeRoom(OtherBoat other, double stoodS) {
        boolean isFirst = surroundings.ownId().compareTo(other.boatId()) < 0;
        return !isFirst && stoodS >= STOOD_BESIDE_S && other.isSlow();
    }

    private boolean isStillComing(OtherBoat other, double eastM, double northM, long nowMs) {
        double awayM = PlaneMath.length(eastM - other.eastM(nowMs), northM - other.northM(nowMs));
        if (makesRoom) {
            return other.isUnderWay() && awayM < NEAR_M;
        }
        return other.isUnderWay() && awayM < FORGOTTEN_M && isAhead(other, eastM, northM, -PASSED_M, nowMs);
    }

    /** Whether a place is ahead of a boat by more than that, in metres: as it heads, or as it goes once it can. */
    private static boolean isAhead(OtherBoat other, double eastM, double northM, double leastM, long nowMs) {
        double awayEastM = eastM - other.eastM(nowMs);
        double awayNorthM = northM - other.northM(nowMs);
        double courseRad = other.courseRad(nowMs);
        return awayEastM * other.aheadEast() + awayNorthM * other.aheadNorth() > leastM
                || awayEastM * StrictMath.sin(courseRad) + awayNorthM * StrictMath.cos(courseRad) > leastM;
    }

    /** Aside from the other's course where there is room, else back on the trail. */
    private LineAhead back(OtherBoat other, double eastM, double northM, long nowMs) {
        double courseRad = other.courseRad(nowMs);
        double starboardEast = StrictMath.cos(courseRad);
        double starboardNorth = -StrictMath.sin(courseRad);
        double besideM = (eastM - other.eastM(nowMs)) * starboardEast + (northM - other.northM(nowMs)) * starboardNorth;
        if (Math.abs(besideM) >= ENOUGH * roomM) {
            return STAY;
        }
        double nearerM = besideM < 0 ? -roomM : roomM;
        for (double side : new double[] {nearerM, -nearerM}) {
            double shiftM = side - besideM;
            double toEastM = eastM + shiftM * starboardEast;
            double toNorthM = northM + shiftM * starboardNorth;
            if (surroundings.border().allowsStraight(eastM, northM, toEastM, toNorthM)
                    && isFree(toEastM, toNorthM, nowMs)) {
                return LineAhead.straight(
                        StrictMath.atan2(shiftM * starboardEast, shiftM * starboardNorth), Math.abs(shiftM));
            }
        }
        return trail.back(surroundings, eastM, northM).orElse(STAY);
    }

    /** Away from the other, where there is room. */
    private LineAhead away(OtherBoat other, double eastM, double northM, long nowMs) {
        double awayRad = StrictMath.atan2(eastM - other.eastM(nowMs), northM - other.northM(nowMs));
        for (double offsetDeg : AWAY_DEG) {
            double courseRad = awayRad + Math.toRadians(offsetDeg);
            double toEastM = eastM + AWAY_M * StrictMath.sin(courseRad);
            double toNorthM = northM + AWAY_M * StrictMath.cos(courseRad);
            if (surroundings.border().allowsStraight(eastM, northM, toEastM, toNorthM)
                    && isFree(toEastM, toNorthM, nowMs)) {
                return LineAhead.straight(courseRad, AWAY_M);
            }
        }
        return STAY;
    }

    /** Whether nobody is there. */
    private boolean isFree(double eastM, double northM, long nowMs) {
        for (OtherBoat other : surroundings.others()) {
            if (PlaneMath.length(other.eastM(nowMs) - eastM, other.northM(nowMs) - northM) < GivingWay.APART_M) {
                return false;
            }
        }
        return true;
    }
}
