package org.sami.boat.server.traffic;

import java.util.Optional;
import org.sami.boat.server.vehicle.PlaneMath;

/**
 * Makes a boat back up when another boat comes towards it and no-go areas leave no room to pass. It returns the way it came until there is room
 * aside, and waits there until the other has passed. The boat without right of way backs up first. A boat also backs up when a no-go area lies
 * between it and its line, and makes room when it has stood for long next to a boat with right of way.
 */
final class GoingBack {
    // how long a boat stands before it backs up
    private static final double STANDING_S = 6;
    private static final double STANDING_WITH_RIGHT_OF_WAY_S = 30; // the other boat apparently cannot back up
    private static final double STANDING_NEXT_TO_S = 12; // next to a standing boat with right of way

    private static final double MAKE_ROOM_STEP_M = 3;
    private static final double[] MAKE_ROOM_DEG = {0, 45, -45, 90, -90}; // from the direction away from the other
    private static final long MAX_WAIT_MS = 20_000; // a boat that has not passed by then is waiting too
    private static final double NEAR_M = 10;
    private static final double OUT_OF_RANGE_M = 30;
    private static final double PASSED_M = 2;
    private static final double TOWARDS_COSINE = 0.5; // of the largest angle that still counts as towards
    private static final double ROOM_TOLERANCE = 0.95; // share of the room that is enough
    private static final LineAhead STAY = LineAhead.straight(0, 0);

    private final Surroundings surroundings;
    private final double roomM;
    private final Trail trail = new Trail();
    private String fromId = ""; // the boat it backs away from
    private boolean makesRoom; // for that boat, which is not coming towards it
    private boolean returns; // to where nothing lies between it and its line
    private long waitsSinceMs = Long.MAX_VALUE;

    /**
     * At the start no boat is coming.
     *
     * @param roomM distance from the other's course that lets it pass, in metres
     */
    GoingBack(Surroundings surroundings, double roomM) {
        this.surroundings = surroundings;
        this.roomM = roomM;
    }

    /** Records a position on the way here. */
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
     * The line on which to back up now: without length where the boat waits, empty where it does not back up.
     *
     * @param wantedRad the intended course, without others
     * @param standingS how long the boat has made no headway, in seconds
     * @param isBarred whether a no-go area lies between the boat and its line
     */
    Optional<LineAhead> way(
            double eastM, double northM, double wantedRad, double standingS, boolean isBarred, long nowMs) {
        Optional<OtherBoat> coming = coming(eastM, northM, wantedRad, standingS, nowMs);
        if (fromId.isEmpty()) {
            makesRoom = coming.isPresent() && isToMakeRoom(coming.get(), standingS);
        }
        fromId = coming.isPresent() ? coming.get().boatId() : "";
        if (!coming.isPresent()) {
            makesRoom = false;
            returns = isBarred && (returns || standingS >= STANDING_S);
            return returns ? trail.back(surroundings, eastM, northM) : Optional.empty();
        }
        LineAhead back =
                makesRoom ? away(coming.get(), eastM, northM, nowMs) : back(coming.get(), eastM, northM, nowMs);
        waitsSinceMs = back == STAY ? Math.min(waitsSinceMs, nowMs) : Long.MAX_VALUE;
        if (back == STAY && nowMs - waitsSinceMs > MAX_WAIT_MS) {
            end();
            return Optional.empty();
        }
        return Optional.of(back);
    }

    private Optional<OtherBoat> coming(double eastM, double northM, double wantedRad, double standingS, long nowMs) {
        if (fromId.isEmpty() && standingS < STANDING_S) {
            return Optional.empty(); // the usual case: too soon to back up
        }
        for (OtherBoat other : surroundings.others()) {
            boolean isComing = fromId.isEmpty()
                    ? isMet(other, eastM, northM, wantedRad, standingS, nowMs)
                    : other.boatId().equals(fromId) && isStillComing(other, eastM, northM, nowMs);
            if (isComing) {
                return Optional.of(other);
            }
        }
        return Optional.empty();
    }

    /** Whether the two boats face each other and this one has to back up. */
    private boolean isMet(
            OtherBoat other, double eastM, double northM, double wantedRad, double standingS, long nowMs) {
        boolean isFirst = surroundings.ownId().compareTo(other.boatId()) < 0;
        if (standingS < (isFirst ? STANDING_WITH_RIGHT_OF_WAY_S : STANDING_S)
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
        return isToMakeRoom(other, standingS)
                || (onMyWayM > TOWARDS_COSINE * awayM && isAhead(other, eastM, northM, TOWARDS_COSINE * awayM, nowMs));
    }

    /** Whether this boat has to make room for a standing boat with right of way, wherever that one is heading. */
    private boolean isToMakeRoom(OtherBoat other, double standingS) {
        boolean isFirst = surroundings.ownId().compareTo(other.boatId()) < 0;
        return !isFirst && standingS >= STANDING_NEXT_TO_S && other.isSlow();
    }

    private boolean isStillComing(OtherBoat other, double eastM, double northM, long nowMs) {
        double awayM = PlaneMath.length(eastM - other.eastM(nowMs), northM - other.northM(nowMs));
        if (makesRoom) {
            return other.isUnderWay() && awayM < NEAR_M;
        }
        return other.isUnderWay() && awayM < OUT_OF_RANGE_M && isAhead(other, eastM, northM, -PASSED_M, nowMs);
    }

    /** Whether a place lies more than {@code leastM} metres ahead of a boat, along its heading or along the course it takes once it can. */
    private static boolean isAhead(OtherBoat other, double eastM, double northM, double leastM, long nowMs) {
        double awayEastM = eastM - other.eastM(nowMs);
        double awayNorthM = northM - other.northM(nowMs);
        double courseRad = other.courseRad(nowMs);
        return awayEastM * other.aheadEast() + awayNorthM * other.aheadNorth() > leastM
                || awayEastM * StrictMath.sin(courseRad) + awayNorthM * StrictMath.cos(courseRad) > leastM;
    }

    /** Aside from the other's course where there is room, otherwise back on the trail. */
    private LineAhead back(OtherBoat other, double eastM, double northM, long nowMs) {
        double courseRad = other.courseRad(nowMs);
        double starboardEast = StrictMath.cos(courseRad);
        double starboardNorth = -StrictMath.sin(courseRad);
        double besideM = (eastM - other.eastM(nowMs)) * starboardEast + (northM - other.northM(nowMs)) * starboardNorth;
        if (Math.abs(besideM) >= ROOM_TOLERANCE * roomM) {
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
        for (double offsetDeg : MAKE_ROOM_DEG) {
            double courseRad = awayRad + Math.toRadians(offsetDeg);
            double toEastM = eastM + MAKE_ROOM_STEP_M * StrictMath.sin(courseRad);
            double toNorthM = northM + MAKE_ROOM_STEP_M * StrictMath.cos(courseRad);
            if (surroundings.border().allowsStraight(eastM, northM, toEastM, toNorthM)
                    && isFree(toEastM, toNorthM, nowMs)) {
                return LineAhead.straight(courseRad, MAKE_ROOM_STEP_M);
            }
        }
        return STAY;
    }

    /** Whether no boat is near that place. */
    private boolean isFree(double eastM, double northM, long nowMs) {
        for (OtherBoat other : surroundings.others()) {
            if (PlaneMath.length(other.eastM(nowMs) - eastM, other.northM(nowMs) - northM) < GivingWay.APART_M) {
                return false;
            }
        }
        return true;
    }
}
