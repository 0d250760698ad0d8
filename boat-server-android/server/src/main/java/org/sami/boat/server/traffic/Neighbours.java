package org.sami.boat.server.traffic;

import java.util.List;
import org.sami.boat.server.vehicle.PlaneMath;

/**
 * The other boats that can come near this one within seconds: where they can stop, and how near this boat comes to them by a course and speed. Positions
 * are in metres on the plane of {@link Surroundings}.
 */
final class Neighbours {
    /** How far ahead others are looked at, in seconds. */
    private static final double AHEAD_S = 8;

    /** How far ahead a boat looks at those that have to give way to it, in seconds. */
    private static final double AHEAD_WITH_RIGHT_OF_WAY_S = 2.5;

    /** What is nearer in time is a matter of safety, and not of risk, in seconds. */
    private static final double AT_ONCE_S = 1;

    /** Weight of an approach that is to be avoided, where getting on at full speed counts 1. */
    private static final double RISK = 8;

    /** After so many seconds an approach counts half. */
    private static final double HALF_RISK_S = 5;

    private final Surroundings surroundings;
    private double apartM;
    private double wideM; // where there is room
    // the first of these arrays' elements, as many as are counted, are in use
    private OtherBoat[] near = new OtherBoat[0];
    private double[] eastM = new double[0]; // from this boat
    private double[] northM = new double[0];
    private double[] aheadS = new double[0];
    private Segment[] stopping = new Segment[0];
    private double[] leastM = new double[0]; // between the segments on which both stop
    private int count;
    private boolean allStopApart;

    /** Nobody yet. */
    Neighbours(Surroundings surroundings) {
        this.surroundings = surroundings;
    }

    /**
     * Finds those that can come near.
     *
     * @param atEastM where this boat is
     * @param atNorthM where this boat is
     * @param speedMps its speed in m/s
     * @param fastestMps the most that it goes, whatever it chooses, in m/s
     * @param hasWay whether it is under way, so that others may have to give way to it
     * @param keptM how far apart the segments are to be on which two boats stop, in metres
     */
    void update(
            double atEastM,
            double atNorthM,
            double speedMps,
            double fastestMps,
            boolean hasWay,
            double keptM,
            long nowMs) {
        apartM = keptM;
        wideM = keptM + GivingWay.ROOM_M;
        List<OtherBoat> others = surroundings.others();
        makeRoom(others.size());
        count = 0;
        double gainedMps = Math.max(fastestMps, Math.abs(speedMps) + GivingWay.GAINING_MPS2 * Stopping.REACTION_S);
        double ownM = Stopping.distanceM(gainedMps, Stopping.REACTION_S);
        allStopApart = true;
        for (int i = 0; i < others.size(); i++) {
            OtherBoat other = others.get(i);
            double sinceS = other.sinceS(nowMs);
            double awayEastM = other.eastAfterM(sinceS) - atEastM;
            double awayNorthM = other.northAfterM(sinceS) - atNorthM;
            double awayM = Math.sqrt(awayEastM * awayEastM + awayNorthM * awayNorthM);
            double spareM = awayM - ownM - other.stopsWithinM() - apartM;
            if (spareM < 0 || awayM - (fastestMps + Math.abs(other.speedMps())) * AHEAD_S < wideM) {
                near[count] = other;
                eastM[count] = awayEastM;
                northM[count] = awayNorthM;
                boolean precedes = hasWay
                        && other.isUnderWay()
                        && !other.isSlow()
                        && surroundings.ownId().compareTo(other.boatId()) < 0;
                aheadS[count] = precedes ? AHEAD_WITH_RIGHT_OF_WAY_S : AHEAD_S;
                allStopApart &= spareM >= 0;
                count++;
            }
        }
    }

    private void makeRoom(int size) {
        if (near.length < size) {
            near = new OtherBoat[size];
            eastM = new double[size];
            northM = new double[size];
            aheadS = new double[size];
            stopping = new Segment[size];
            leastM = new double[size];
        }
    }

    boolean isEmpty() {
        return count == 0;
    }

    /** Whether all can stop apart whatever this boat does for a moment. */
    boolean allStopApart() {
        return allStopApart;
    }

    /**
     * Measures where they can stop, before {@link #isClear} is asked.
     *
     * @param own where this boat can stop
     */
    void measureStopping(double atEastM, double atNorthM, Segment own) {
        for (int i = 0; i < count; i++) {
            stopping[i] = near[i].stoppingAt(atEastM + eastM[i], atNorthM + northM[i]);
            leastM[i] = own.distanceM(stopping[i], apartM);
        }
    }

    /** Whether a segment on which this boat would stop is far enough from those of the others; no nearer, where it is nearer now. */
    boolean isClear(Segment own) {
        for (int i = 0; i < count; i++) {
            if (own.distanceM(stopping[i], leastM[i]) < leastM[i]) {
                return false;
            }
        }
        return true;
    }

    /** How near others come by a course and speed, and how soon; zero where they do not. Beyond {@code enough} it is not summed up. */
    double risk(Course direction, double atMps, double enough) {
        double eastMps = atMps * direction.east();
        double northMps = atMps * direction.north();
        double risk = 0;
        for (int i = 0; i < count && risk <= enough; i++) {
            double byEast = near[i].eastMps() - eastMps;
            double byNorth = near[i].northMps() - northMps;
            double square = byEast * byEast + byNorth * byNorth;
            double closestS = square > 0 ? -(eastM[i] * byEast + northM[i] * byNorth) / square : 0;
            double atS = Math.max(AT_ONCE_S, Math.min(aheadS[i], closestS));
            double thenEastM = eastM[i] + atS * byEast;
            double thenNorthM = northM[i] + atS * byNorth;
            if (Math.abs(thenEastM) >= wideM || Math.abs(thenNorthM) >= wideM) {
                continue;
            }
            double away = PlaneMath.length(thenEastM, thenNorthM);
            if (away < wideM) {
                double part = (wideM - away) / wideM;
                risk += RISK * part * part / (1 + atS / HALF_RISK_S);
            }
        }
        return risk;
    }

    /** Whether a boat that lies still is on that course, or so near to it that it cannot be passed. */
    boolean isBlocked(Course direction) {
        for (int i = 0; i < count; i++) {
            double aheadM = eastM[i] * direction.east() + northM[i] * direction.north();
            double asideM = Math.abs(eastM[i] * direction.north() - northM[i] * direction.east());
            if (near[i].isSlow() && aheadM > 0 && asideM < apartM) {
                return true;
            }
        }
        return false;
    }
}
