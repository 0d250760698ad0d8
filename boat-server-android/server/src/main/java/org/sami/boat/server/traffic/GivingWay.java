package org.sami.boat.server.traffic;

import java.util.Arrays;
import java.util.Optional;
import org.sami.boat.link.MotionDefaults;
import org.sami.boat.server.vehicle.Kinematics;

/**
 * Makes a boat give way to others. It tries courses and speeds around the intended one and chooses the cheapest that is safe; where nobody is in the
 * way, that is the intended one (after T. A. Johansen, T. Perez, A. Cristofaro, Ship collision avoidance and COLREGS compliance using
 * simulation-based control behavior selection, 2016).
 *
 * <ul>
 *   <li>A motion is safe if the boat's stopping segment after it keeps its distance from the stopping segments of the others. Where no motion is safe,
 *       the boat stops.
 *   <li>A motion is cheap if it makes headway, stays near the boat's line and away from where others will be ({@link Neighbours}).
 *   <li>Of two boats under way, the one whose name comes first has the right of way. Boats at rest and boats driven by hand have it over all others.
 *   <li>Away from its line the boat stays outside no-go areas ({@link NoGoBorder}). Where they leave no room to pass, one of two boats backs up
 *       ({@link GoingBack}).
 * </ul>
 *
 * <p>For the thread that ticks the server.
 */
public final class GivingWay {
    /** Separation of the stopping segments of two boats, in metres: 3, plus what a boat can turn and accelerate before the others know. */
    static final double APART_M = MotionDefaults.SEPARATION_M;

    /** Extra clearance when passing where there is room, in metres; added to {@link #APART_M}. */
    static final double PASSING_CLEARANCE_M = 1;

    /**
     * Margin for position errors, in standard deviations of the distance between two boats. With 2, boats in the field block each other for minutes;
     * with 1, they spend twice as long closer than 3 m (docs/decisions, 0320).
     */
    private static final double ERROR_MARGIN_DEVIATIONS = 1.5;

    // A boat that has given way for a while reduces its margin for position errors, linearly between these two times.
    // Otherwise two boats could block each other forever (docs/link.md).
    private static final double FULL_MARGIN_UNTIL_S = 20;
    private static final double LEAST_MARGIN_FROM_S = 80;
    private static final double MARGIN_REDUCTION = 0.6; // of the margin, at the most
    private static final double WAITING_DECAY = 3; // seconds of giving way that one free second makes up for

    private static final double LOOKAHEAD_S = 2.5; // for the distance from the line
    private static final double ON_LINE_LOOKAHEAD_S = 1; // for the test whether the boat stays on its line

    // Turn rate and acceleration assumed of every hull: at or below what the slowest hull reaches.
    private static final double TURN_RATE_RAD_S = 0.8;
    private static final double REACTION_TURN_RAD = TURN_RATE_RAD_S * Stopping.REACTION_S;
    static final double ACCELERATION_MPS2 = 0.6;

    private static final double SIDESTEP_SPEED_MPS = 0.8; // least speed for moving aside
    private static final double ASTERN_SPEED_MPS = 0.5;
    private static final double PIVOT_SPEED_MPS = 0.2; // a slower boat can turn on the spot
    private static final double MAX_OFFSET_M = 8; // from the line
    private static final double ON_LINE_TOLERANCE_M = 0.6; // steering holds the line no better

    // A boat leaves an edge only if it is this much closer to it than its line is. It starts to leave only if it is
    // closer by this share of the distance kept in addition.
    private static final double EDGE_TOLERANCE_M = 0.3;
    private static final double EDGE_HYSTERESIS = 0.15;

    // the courses tried, in degrees from the intended one, and the shares of the speed
    private static final CourseVector[] OFFSETS =
            offsets(0, 20, -20, 40, -40, 60, -60, 90, -90, 120, -120, 150, -150, 180);
    private static final double NEAR_COURSE_RAD = Math.toRadians(30); // within it the boat keeps to the intended speed
    private static final double[] SPEED_SHARES = {1, 0.6, 0.3};

    // weights of the cost; headway at full speed counts 1; found by trials (docs/decisions, 0320)
    private static final double OFFSET_WEIGHT_PER_M = 0.15;
    private static final double SIDE_CHANGE_WEIGHT = 0.15; // passing on another side than before
    private static final double PORT_WEIGHT = 0.04;
    private static final double IMPATIENCE_WEIGHT_PER_S = 0.1;
    private static final double MAX_WAIT_S = 20;
    private static final double AVOID_BLOCKED_AFTER_S = 8; // of waiting, for courses that are blocked farther on

    private final Surroundings surroundings;
    private final Kinematics vehicle;
    private final GoingBack goingBack;
    private final VesselsInMotion vessels;
    private final Neighbours neighbours;
    private final double turningMps;
    private final double errorMarginM; // for position errors, added to APART_M
    private final TurnLimit leastTurn = new TurnLimit(REACTION_TURN_RAD / 3); // the boat hardly turns yet
    private final TurnLimit farthestTurn = new TurnLimit(1.5 * REACTION_TURN_RAD); // it goes on turning while it stops
    private double eastM; // of the boat, on the plane of the surroundings
    private double northM;
    private double speedMps;
    private CourseVector heading = OFFSETS[0]; // this and the next two: valid while others or an edge are near
    private CourseVector course = OFFSETS[0]; // intended, without others
    private double courseMps;
    private CourseVector line = OFFSETS[0];
    private double offsetM; // of the boat from that line, to starboard
    private double maxOffsetM = MAX_OFFSET_M; // more around large vessels
    private boolean isOnLine; // or no edge is near
    private NoGoBorder border = NoGoBorder.NONE;
    private double chosenRad = Double.NaN; // while it gives way
    private double waitedS; // for others, MAX_WAIT_S at most
    private double standingS; // waiting for others, without limit
    private double givingWayS; // nearly without a break, up to LEAST_MARGIN_FROM_S; zero for a boat without a path
    private boolean leavesEdge; // it has come too near to one
    private boolean turns; // on the spot, before it goes on
    private final LastChoice last = new LastChoice();

    /**
     * Nobody is in the way yet.
     *
     * @param positionErrorM standard deviation of positions along each axis, the boat's own and those of others, in metres
     */
    public GivingWay(Surroundings surroundings, Kinematics vehicle, double positionErrorM) {
        this(surroundings, vehicle, positionErrorM, 0);
    }

    /**
     * The same for a hull that turns only with headway, as one with a rudder does.
     *
     * @param turningMps least speed at which it turns, in m/s; 0 where it turns on the spot
     */
    public GivingWay(Surroundings surroundings, Kinematics vehicle, double positionErrorM, double turningMps) {
        this.turningMps = turningMps;
        this.surroundings = surroundings;
        this.vehicle = vehicle;
        errorMarginM = errorMarginM(positionErrorM);
        neighbours = new Neighbours(surroundings);
        vessels = new VesselsInMotion(surroundings);
        goingBack = new GoingBack(surroundings, APART_M + errorMarginM + PASSING_CLEARANCE_M);
    }

    /** Margin for position errors in metres, added to {@link #APART_M}, for this standard deviation along each axis. */
    static double errorMarginM(double positionErrorM) {
        return ERROR_MARGIN_DEVIATIONS * Math.sqrt(2) * positionErrorM;
    }

    /** Whether the boat deviates from its intended course and speed because of others. */
    public boolean isGivingWay() {
        return !Double.isNaN(chosenRad);
    }

    /** Whether a boat that stands turns to its course, instead of only holding its place. */
    public boolean isTurning() {
        return turns;
    }

    /**
     * The course and speed now. The boat chooses five times a second, as often as it hears of others, and whenever its intention changes.
     *
     * @param wanted the intended course and speed, without others; not astern
     * @param towards the vehicle's heading
     * @param along the line to follow, which stays outside no-go areas
     * @param hasWay whether the boat is under way, so that others may have to give way to it
     * @param seconds since the last call
     */
    public CourseAndSpeed choose(
            CourseAndSpeed wanted, CourseVector towards, LineAhead along, boolean hasWay, long nowMs, double seconds) {
        if (hasWay) {
            goingBack.record(vehicle.latDeg(), vehicle.lonDeg());
        }
        if (last.isInForce(wanted, hasWay, nowMs)) {
            last.lasts(seconds);
            return isGivingWay() ? last.chosen() : wanted;
        }
        turns = false;
        isOnLine = surroundings.border().isEmpty() || isOn(along);
        if (surroundings.isEmpty() && isOnLine) {
            forget();
            return wanted;
        }
        double sinceS = last.sinceS() + seconds;
        CourseAndSpeed chosen = chooseAmongOthers(wanted, towards, along, hasWay, nowMs, sinceS);
        last.set(wanted, hasWay, chosen, nowMs);
        return chosen;
    }

    private CourseAndSpeed chooseAmongOthers(
            CourseAndSpeed wanted, CourseVector towards, LineAhead along, boolean hasWay, long nowMs, double seconds) {
        update(Math.max(wanted.speedMps(), SIDESTEP_SPEED_MPS), hasWay, nowMs);
        if (!neighbours.isEmpty() || !border.isEmpty()) {
            heading = towards;
            leastTurn.setHeading(heading);
            farthestTurn.setHeading(heading);
            course = wanted.course();
            courseMps = wanted.speedMps();
        }
        boolean isRisky = neighbours.risk(course, courseMps, 0) > 0;
        boolean isFree = !isRisky && neighbours.allStopApart() && isOnLine; // the usual case
        if (!isFree) {
            measureStopping(along);
        }
        Optional<LineAhead> off = hasWay && !isOnLine ? border.off() : Optional.empty();
        leavesEdge = off.isPresent()
                && off.get().aheadM()
                        > (leavesEdge ? EDGE_TOLERANCE_M : EDGE_TOLERANCE_M + border.keepM() * EDGE_HYSTERESIS);
        if (leavesEdge) {
            return goBack(off.get());
        }
        Optional<LineAhead> aside = hasWay
                ? vessels.way(
                        eastM,
                        northM,
                        wanted.course(),
                        wanted.speedMps(),
                        Math.abs(Stopping.distanceM(speedMps, Stopping.REACTION_S)),
                        APART_M + errorMarginM + PASSING_CLEARANCE_M,
                        nowMs)
                : Optional.empty();
        if (aside.isPresent()) {
            if (isFree) {
                measureStopping(along);
            }
            return goBack(aside.get());
        }
        boolean isBarred = !isOnLine && !border.seesLine();
        Optional<LineAhead> back = hasWay
                ? goingBack.way(eastM, northM, wanted.courseRad(), standingS, isBarred, nowMs)
                : Optional.empty();
        if (back.isPresent()) {
            return goBack(back.get());
        }
        isFree = isFree || (!isRisky && isSafe(course, courseMps, isOnLine));
        givingWayS = hasWay ? givingWayS(isFree ? -WAITING_DECAY * seconds : seconds) : 0;
        return isFree ? goOn(wanted, seconds) : giveWay(along, seconds);
    }

    private double givingWayS(double longerS) {
        return Math.max(0, Math.min(LEAST_MARGIN_FROM_S, givingWayS + longerS));
    }

    private CourseAndSpeed goOn(CourseAndSpeed wanted, double seconds) {
        chosenRad = Double.NaN;
        waitedS = Math.max(0, waitedS - seconds);
        if (Math.abs(speedMps) >= PIVOT_SPEED_MPS) { // a slower boat may only be turning
            standingS = 0;
        }
        return wanted;
    }

    private CourseAndSpeed giveWay(LineAhead along, double seconds) {
        line = new CourseVector(along.courseRad());
        offsetM = along.offsetM();
        maxOffsetM = MAX_OFFSET_M + 2 * neighbours.largestRadiusM();
        boolean waits = speedMps * heading.along(course) < courseMps / 5;
        waitedS = waits ? Math.min(MAX_WAIT_S, waitedS + seconds) : Math.max(0, waitedS - seconds);
        standingS = waits ? standingS + seconds : Math.max(0, standingS - seconds);
        CourseAndSpeed best = best();
        chosenRad = best.courseRad();
        return best;
    }

    private CourseAndSpeed goBack(LineAhead along) {
        standingS = 0;
        chosenRad = along.courseRad();
        isOnLine = false; // no planner has checked this line
        if (along.aheadM() == 0) {
            return new CourseAndSpeed(heading.rad(), 0);
        }
        course = new CourseVector(along.courseRad());
        courseMps = SIDESTEP_SPEED_MPS;
        line = course;
        offsetM = 0;
        maxOffsetM = MAX_OFFSET_M;
        measureStopping(along);
        return best();
    }

    /** Whether the boat is on its line and stays on it: the line then keeps it outside no-go areas. */
    private boolean isOn(LineAhead along) {
        double nowM = along.offsetM();
        double thenM = nowM
                + vehicle.speedMps() * StrictMath.sin(vehicle.headingRad() - along.courseRad()) * ON_LINE_LOOKAHEAD_S;
        return Math.abs(nowM) <= ON_LINE_TOLERANCE_M && Math.abs(thenM) <= ON_LINE_TOLERANCE_M;
    }

    private void forget() {
        chosenRad = Double.NaN;
        waitedS = 0;
        standingS = 0;
        givingWayS = 0;
        goingBack.end();
        last.forget();
    }

    // ---- who is near

    /**
     * Updates this boat's position, the no-go edges and the boats that can come near.
     *
     * @param fastestMps highest speed that this boat may choose, in m/s
     */
    private void update(double fastestMps, boolean hasWay, long nowMs) {
        eastM = surroundings.plane().eastM(vehicle.latDeg(), vehicle.lonDeg());
        northM = surroundings.plane().northM(vehicle.latDeg(), vehicle.lonDeg());
        if (surroundings.border().isPast(eastM, northM)) {
            surroundings.forgetBorder();
        }
        border = surroundings.border();
        speedMps = vehicle.speedMps();
        double waitShare =
                Math.max(0, (givingWayS - FULL_MARGIN_UNTIL_S) / (LEAST_MARGIN_FROM_S - FULL_MARGIN_UNTIL_S));
        double keptM = APART_M + errorMarginM * (1 - MARGIN_REDUCTION * waitShare);
        neighbours.update(eastM, northM, speedMps, fastestMps, hasWay, keptM, nowMs);
    }

    /** Measures the stopping segments of the others and the distances to keep from no-go edges; called before {@link #isSafe}. */
    private void measureStopping(LineAhead along) {
        Segment own = Stopping.segment(eastM, northM, heading, speedMps, 0);
        neighbours.measureStopping(eastM, northM, own);
        double soonM = Math.abs(Stopping.distanceM(speedMps, 2 * Stopping.REACTION_S)) + 1;
        border.measure(eastM, northM, own, along, soonM);
    }

    // ---- safety and cost of a motion

    /**
     * Whether the boat, after its reaction time on this course, can still stop at its distance from others and from no-go edges. Where it is closer
     * already, it may not come closer still.
     *
     * @param followsLine whether the boat follows its line, which keeps it outside no-go areas
     */
    private boolean isSafe(CourseVector direction, double atMps, boolean followsLine) {
        double turn = direction.turnFrom(heading.rad());
        double wantedMps = whileTurningMps(atMps, direction.along(heading));
        double gain = ACCELERATION_MPS2 * Stopping.REACTION_S;
        double thenMps = speedMps + clamped(wantedMps - speedMps, gain);
        CourseVector least = leastTurn.after(direction, turn);
        CourseVector farthest = leastTurn.allows(turn) ? least : farthestTurn.after(direction, turn);
        double wayM = (speedMps + thenMps) / 2 * Stopping.REACTION_S;
        double thenEastM = eastM + wayM * least.east();
        double thenNorthM = northM + wayM * least.north();
        return isClear(Stopping.segment(thenEastM, thenNorthM, least, thenMps, 0), followsLine)
                && (farthest == least
                        || isClear(Stopping.segment(thenEastM, thenNorthM, farthest, thenMps, 0), followsLine));
    }

    /**
     * The speed at which the boat turns to a course, in m/s.
     *
     * @param atMps speed on the course; not astern
     * @param along cosine of the turn
     */
    public double whileTurningMps(double atMps, double along) {
        return Math.max(Math.min(atMps, turningMps), atMps * Math.max(0, along));
    }

    /** Whether a boat that hardly moves can take this course after turning on the spot. */
    private boolean isSafeOnceTurned(CourseVector direction, boolean followsLine) {
        return isClear(Stopping.segment(eastM, northM, direction, ASTERN_SPEED_MPS, Stopping.REACTION_S), followsLine);
    }

    private static double clamped(double value, double most) {
        return Math.max(-most, Math.min(most, value));
    }

    private boolean isClear(Segment own, boolean followsLine) {
        return neighbours.isClear(own) && (followsLine || border.allows(own));
    }

    /** The cheapest safe motion, or a stop where none is safe. */
    private CourseAndSpeed best() {
        CourseVector best = Math.abs(speedMps) > 0.3 ? heading : course;
        double bestMps = 0;
        double least = cost(best, bestMps, Double.MAX_VALUE);
        double fullMps = Math.max(courseMps, SIDESTEP_SPEED_MPS);
        boolean turnsFirst = !border.isEmpty() && Math.abs(speedMps) < PIVOT_SPEED_MPS;
        for (CourseVector offset : OFFSETS) {
            CourseVector other = course.turned(offset);
            boolean followsLine = isOnLine && offset == OFFSETS[0];
            double toPort = offset.rad() < 0 ? PORT_WEIGHT : 0;
            for (double part : SPEED_SHARES) {
                double mps = part * (Math.abs(offset.rad()) < NEAR_COURSE_RAD ? courseMps : fullMps);
                double cost = toPort + cost(other, mps, least - toPort);
                if (cost < least && (!turnsFirst || isSafeOnceTurned(other, followsLine))) {
                    boolean isSafe = isSafe(other, mps, followsLine);
                    if (isSafe || turnsFirst) {
                        least = cost;
                        best = other;
                        turns = !isSafe;
                        bestMps = isSafe ? mps : 0;
                    }
                }
            }
        }
        boolean astern = cost(heading, -ASTERN_SPEED_MPS, least) < least && isSafeAstern();
        turns &= !astern;
        return astern ? new CourseAndSpeed(heading.rad(), -ASTERN_SPEED_MPS) : new CourseAndSpeed(best.rad(), bestMps);
    }

    private boolean isSafeAstern() {
        return isClear(Stopping.segment(eastM, northM, heading, -ASTERN_SPEED_MPS, Stopping.REACTION_S), false);
    }

    /** The cost of a motion; exact only where it is below {@code leastCost}. */
    private double cost(CourseVector direction, double mps, double leastCost) {
        double onward = mps * direction.along(course) / Math.max(courseMps, SIDESTEP_SPEED_MPS);
        if (onward > 0 && waitedS > AVOID_BLOCKED_AFTER_S && neighbours.isBlocked(direction)) {
            onward = 0;
        }
        double thenM = Math.abs(offsetM + mps * direction.across(line) * LOOKAHEAD_S);
        double patience = 1 / (1 + IMPATIENCE_WEIGHT_PER_S * waitedS);
        double offset = patience * OFFSET_WEIGHT_PER_M * Math.max(0, thenM - 0.5);
        double tooFar = thenM > maxOffsetM && thenM > Math.abs(offsetM) ? thenM - maxOffsetM : 0;
        boolean waits = Math.abs(mps) < SIDESTEP_SPEED_MPS / 4
                || (mps < 0 && waitedS > AVOID_BLOCKED_AFTER_S); // going to and fro is no headway
        double waiting = waits ? IMPATIENCE_WEIGHT_PER_S * waitedS : 0;
        double turning = Double.isNaN(chosenRad) || mps <= 0
                ? 0
                : SIDE_CHANGE_WEIGHT * Math.abs(direction.turnFrom(chosenRad)) / (Math.PI / 2);
        double withoutRisk = 1 - onward + offset + tooFar + waiting + turning;
        return withoutRisk < leastCost
                ? withoutRisk + neighbours.risk(direction, mps, leastCost - withoutRisk)
                : withoutRisk;
    }

    private static CourseVector[] offsets(double... degrees) {
        return Arrays.stream(degrees)
                .mapToObj(offset -> new CourseVector(Math.toRadians(offset)))
                .toArray(CourseVector[]::new);
    }
}
