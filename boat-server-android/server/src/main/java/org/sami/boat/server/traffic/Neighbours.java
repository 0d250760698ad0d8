package org.sami.boat.server.traffic;

import java.util.List;
import org.sami.boat.server.vehicle.PlaneMath;

/**
 * The boats that can come near this one within seconds: their stopping segments, and how close this boat comes to them on a course and speed.
 * Positions are in metres on the plane of {@link Surroundings}.
 */
final class Neighbours {
    /** Look-ahead for other boats, in seconds. */
    private static final double LOOKAHEAD_S = 8;

    /** Look-ahead for boats that have to give way to this one, in seconds. */
    private static final double LOOKAHEAD_WITH_RIGHT_OF_WAY_S = 2.5;

    /** Earliest approach that counts as a risk, in seconds; earlier ones are excluded by the stopping segments. */
    private static final double EARLIEST_RISK_S = 1;

    /** Weight of an approach in the cost of a motion, in which headway at full speed counts 1. */
    private static final double RISK_WEIGHT = 8;

    /** An approach this many seconds ahead counts half. */
    private static final double RISK_HALVING_S = 5;

    private final Surroundings surroundings;
    private double apartM;
    private double passingM; // separation where there is room
    // the first count elements of these arrays are in use
    private OtherBoat[] near = new OtherBoat[0];
    private double[] eastM = new double[0]; // from this boat
    private double[] northM = new double[0];
    private double[] aheadS = new double[0];
    private Segment[] stopping = new Segment[0];
    private double[] leastM = new double[0]; // between both stopping segments
    private int count;
    private boolean allStopApart;

    /** No boat is near yet. */
    Neighbours(Surroundings surroundings) {
        this.surroundings = surroundings;
    }

    /**
     * Finds the boats that can come near.
     *
     * @param atEastM position of this boat
     * @param atNorthM position of this boat
     * @param speedMps its speed in m/s
     * @param fastestMps highest speed that it may choose, in m/s
     * @param hasWay whether it is under way, so that others may have to give way to it
     * @param keptM separation of the stopping segments of two boats, in metres
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
        passingM = keptM + GivingWay.PASSING_CLEARANCE_M;
        List<OtherBoat> others = surroundings.others();
        makeRoom(others.size());
        count = 0;
        double gainedMps = Math.max(fastestMps, Math.abs(speedMps) + GivingWay.ACCELERATION_MPS2 * Stopping.REACTION_S);
        double ownM = Stopping.distanceM(gainedMps, Stopping.REACTION_S);
        allStopApart = true;
        for (int i = 0; i < others.size(); i++) {
            OtherBoat other = others.get(i);
            double sinceS = other.sinceS(nowMs);
            double awayEastM = other.eastAfterM(sinceS) - atEastM;
            double awayNorthM = other.northAfterM(sinceS) - atNorthM;
            double awayM = Math.sqrt(awayEastM * awayEastM + awayNorthM * awayNorthM);
            double roomM = awayM - other.radiusM();
            double spareM = roomM - ownM - other.stopsWithinM() - apartM;
            if (spareM < 0 || roomM - (fastestMps + Math.abs(other.speedMps())) * LOOKAHEAD_S < passingM) {
                near[count] = other;
                eastM[count] = awayEastM;
                northM[count] = awayNorthM;
                boolean precedes = hasWay
                        && other.isUnderWay()
                        && !other.isSlow()
                        && surroundings.ownId().compareTo(other.boatId()) < 0;
                aheadS[count] = precedes ? LOOKAHEAD_WITH_RIGHT_OF_WAY_S : LOOKAHEAD_S;
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

    /** Whether all boats can keep their separation, whatever this boat does within its reaction time. */
    boolean allStopApart() {
        return allStopApart;
    }

    /**
     * Measures the stopping segments of the others; called before {@link #isClear}.
     *
     * @param own stopping segment of this boat
     */
    void measureStopping(double atEastM, double atNorthM, Segment own) {
        for (int i = 0; i < count; i++) {
            stopping[i] = near[i].stoppingAt(atEastM + eastM[i], atNorthM + northM[i]);
            leastM[i] = own.distanceM(stopping[i], apartM + near[i].radiusM());
        }
    }

    /** Whether a stopping segment of this boat keeps its separation from the others, or where it is closer already, comes no closer. */
    boolean isClear(Segment own) {
        for (int i = 0; i < count; i++) {
            if (own.distanceM(stopping[i], leastM[i]) < leastM[i]) {
                return false;
            }
        }
        return true;
    }

    /** Risk of a course and speed: how close others come, and how soon; zero where none does. The sum stops once it exceeds {@code enough}. */
    double risk(CourseVector direction, double atMps, double enough) {
        double eastMps = atMps * direction.east();
        double northMps = atMps * direction.north();
        double risk = 0;
        for (int i = 0; i < count && risk <= enough; i++) {
            double byEast = near[i].eastMps() - eastMps;
            double byNorth = near[i].northMps() - northMps;
            double square = byEast * byEast + byNorth * byNorth;
            double closestS = square > 0 ? -(eastM[i] * byEast + northM[i] * byNorth) / square : 0;
            double atS = Math.max(EARLIEST_RISK_S, Math.min(aheadS[i], closestS));
            double thenEastM = eastM[i] + atS * byEast;
            double thenNorthM = northM[i] + atS * byNorth;
            double passM = passingM + near[i].radiusM();
            if (Math.abs(thenEastM) >= passM || Math.abs(thenNorthM) >= passM) {
                continue;
            }
            double away = PlaneMath.length(thenEastM, thenNorthM);
            if (away < passM) {
                double part = (passM - away) / passM;
                risk += RISK_WEIGHT * part * part / (1 + atS / RISK_HALVING_S);
            }
        }
        return risk;
    }

    /** The largest radius of those that can come near, in metres. */
    double largestRadiusM() {
        double largestM = 0;
        for (int i = 0; i < count; i++) {
            largestM = Math.max(largestM, near[i].radiusM());
        }
        return largestM;
    }

    /** Whether a boat that lies still blocks this course. */
    boolean isBlocked(CourseVector direction) {
        for (int i = 0; i < count; i++) {
            double aheadM = eastM[i] * direction.east() + northM[i] * direction.north();
            double asideM = Math.abs(eastM[i] * direction.north() - northM[i] * direction.east());
            if (near[i].isSlow() && aheadM > 0 && asideM < apartM + near[i].radiusM()) {
                return true;
            }
        }
        return false;
    }
}
