package org.sami.boat.server.traffic;

import java.util.Arrays;
import java.util.Optional;
import org.sami.boat.server.vehicle.Vehicle;

/**
 * Has a boat give way to others: of some courses and speeds around the wanted one it chooses the cheapest that is safe. That is the wanted one where
 * nobody is in the way (after T. A. Johansen, T. Perez, A. Cristofaro, Ship collision avoidance and COLREGS compliance using simulation-based
 * control behavior selection, 2016).
 *
 * <ul>
 *   <li>A motion is safe if the segment on which the boat could stop then is apart from those on which others could stop now. Where none is safe, the
 *       boat stops.
 *   <li>A motion is cheap if it brings the boat on, keeps it near its line, and away from where others will be ({@link Neighbours}).
 *   <li>Of two boats under way, the one whose name comes first has the right of way. Boats at rest, and those that a person drives, have it over all.
 *   <li>Off its line the boat keeps out of what it is not to enter ({@link NoGoBorder}). Where that leaves no room to pass, one of two boats goes back
 *       ({@link GoingBack}).
 * </ul>
 *
 * <p>For the thread that ticks the server.
 */
public final class GivingWay {
    /** Distance between the segments on which two boats stop, in metres: 3, and what a boat may turn and gain speed until others know. */
    static final double APART_M = 3.5;

    /** What boats keep on top of it in passing where there is room, in metres. */
    static final double ROOM_M = 1;

    /**
     * How many standard deviations of the distance between two boats are kept on top where positions err. With 2, boats in the field hold each other
     * up for minutes; with 1 they are under 3 m for twice as long (docs/decisions, 0320).
     */
    private static final double DEVIATIONS = 1.5;

    // Who has given way for long keeps less of that, as boats that may not pass each other at all would hold each other
    // up for ever: less from the first of these times on, and by that part less from the second (docs/decisions, 0327).
    private static final double LONG_S = 20;
    private static final double LONGEST_S = 80;
    private static final double KEPT_LESS = 0.6;
    private static final double FREE = 3; // a second without anybody in the way counts against so many with

    private static final double SOON_S = 2.5; // so long ahead it looks how far it comes beside its line
    private static final double ON_LINE_AHEAD_S = 1; // so long ahead it is to stay on its line

    // what hulls do, or a little less: so they are safe by what they can
    private static final double TURNING_RAD_S = 0.8;
    private static final double MOST_RAD = TURNING_RAD_S * Stopping.REACTION_S; // within a moment
    static final double GAINING_MPS2 = 0.6;

    private static final double ASIDE_MPS = 0.8; // so fast at least a boat goes aside
    private static final double ASTERN_MPS = 0.5;
    private static final double SLOW_MPS = 0.2; // turns on the spot
    private static final double FARTHEST_M = 8; // from its line
    private static final double ON_LINE_M = 0.6; // steering keeps it no nearer to it
    private static final double OFF_M = 0.3; // so much nearer to an edge than its line it need not be to go off it
    private static final double OFF_PART = 0.15; // of what it keeps, on top of that until it begins to

    // the courses that are tried, beside the wanted one in degrees, and the parts of the speed
    private static final Course[] OFFSETS = offsets(0, 20, -20, 40, -40, 60, -60, 90, -90, 120, -120, 150, -150, 180);
    private static final double ON_COURSE_RAD = Math.toRadians(30); // nearer to it no faster than the boat wants to
    private static final double[] PARTS = {1, 0.6, 0.3};

    // weights of the cost, where getting on at full speed counts 1; found by trials (docs/decisions, 0320)
    private static final double BESIDE_PER_M = 0.15;
    private static final double TURNING_BACK = 0.15; // for another side than before
    private static final double TO_PORT = 0.04;
    private static final double IMPATIENCE_PER_S = 0.1;
    private static final double LONGEST_WAIT_S = 20;
    private static final double HELD_UP_S = 8; // from then on it goes nowhere that is blocked a little farther on

    private final Surroundings surroundings;
    private final Vehicle vehicle;
    private final GoingBack goingBack;
    private final Neighbours neighbours;
    private final double forErrorsM; // that boats keep on top of what they keep apart, as positions err
    private final TurnLimit leastTurn = new TurnLimit(MOST_RAD / 3); // where it hardly turns yet
    private final TurnLimit farthestTurn = new TurnLimit(1.5 * MOST_RAD); // where it goes on turning while it stops
    private double eastM; // of the boat, on the plane of the surroundings
    private double northM;
    private double speedMps;
    private Course heading = OFFSETS[0]; // this and what follows up to the others: as long as some of those are near
    private Course course = OFFSETS[0]; // that it would take without others
    private double courseMps;
    private Course line = OFFSETS[0];
    private double besideM; // that line
    private boolean isOnLine; // or nothing bounds where it may go
    private NoGoBorder border = NoGoBorder.NONE;
    private double chosenRad = Double.NaN; // while it gives way
    private double waitedS; // for others, LONGEST_WAIT_S at most
    private double stoodS; // the same, however long it lasts
    private double gaveWayS; // without a break, or nearly so, LONGEST_S at most; zero for who has no way to go
    private boolean goesOff; // an edge that it has come too near to
    private boolean turns; // on the spot, to go on then
    private final LastChoice last = new LastChoice();

    /**
     * Nobody is in the way yet.
     *
     * @param positionErrorM standard deviation of positions along each axis, the boat's own and those of others, in metres
     */
    public GivingWay(Surroundings surroundings, Vehicle vehicle, double positionErrorM) {
        this.surroundings = surroundings;
        this.vehicle = vehicle;
        forErrorsM = forErrorsM(positionErrorM);
        neighbours = new Neighbours(surroundings);
        goingBack = new GoingBack(surroundings, APART_M + forErrorsM + ROOM_M);
    }

    /** What boats keep on top of {@link #APART_M}, in metres, where positions have this standard deviation along each axis. */
    static double forErrorsM(double positionErrorM) {
        return DEVIATIONS * Math.sqrt(2) * positionErrorM;
    }

    /** Whether the boat goes otherwise than it would without others. */
    public boolean isGivingWay() {
        return !Double.isNaN(chosenRad);
    }

    /** Whether a boat that is not to get on is to turn to its course, and not only to stay where it is. */
    public boolean isTurning() {
        return turns;
    }

    /**
     * Where the boat goes now: it chooses anew five times a second, as often as it hears of others, and where it wants to go elsewhere.
     *
     * @param wanted where it would go without others; not astern
     * @param towards the vehicle's heading
     * @param along the line that it is to follow, clear of what it is not to enter
     * @param hasWay whether it is under way, so that others may have to give way to it
     * @param seconds since it was asked for last
     */
    public CourseAndSpeed choose(
            CourseAndSpeed wanted, Course towards, LineAhead along, boolean hasWay, long nowMs, double seconds) {
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
            CourseAndSpeed wanted, Course towards, LineAhead along, boolean hasWay, long nowMs, double seconds) {
        update(Math.max(wanted.speedMps(), ASIDE_MPS), hasWay, nowMs);
        if (!neighbours.isEmpty() || !border.isEmpty()) {
            heading = towards;
            leastTurn.setHeading(heading);
            farthestTurn.setHeading(heading);
            course = wanted.course();
            courseMps = wanted.speedMps();
        }
        boolean isRisky = neighbours.risk(course, courseMps, 0) > 0;
        boolean isFree = !isRisky && neighbours.allStopApart() && isOnLine; // most of the time
        if (!isFree) {
            measureStopping(along);
        }
        Optional<LineAhead> off = hasWay && !isOnLine ? border.off() : Optional.empty();
        goesOff = off.isPresent() && off.get().aheadM() > (goesOff ? OFF_M : OFF_M + border.keepM() * OFF_PART);
        if (goesOff) {
            return goBack(off.get());
        }
        boolean isBarred = !isOnLine && !border.seesLine();
        Optional<LineAhead> back =
                hasWay ? goingBack.way(eastM, northM, wanted.courseRad(), stoodS, isBarred, nowMs) : Optional.empty();
        if (back.isPresent()) {
            return goBack(back.get());
        }
        isFree = isFree || (!isRisky && isSafe(course, courseMps, isOnLine));
        gaveWayS = hasWay ? gaveWayS(isFree ? -FREE * seconds : seconds) : 0;
        return isFree ? goOn(wanted, seconds) : giveWay(along, seconds);
    }

    private double gaveWayS(double longerS) {
        return Math.max(0, Math.min(LONGEST_S, gaveWayS + longerS));
    }

    private CourseAndSpeed goOn(CourseAndSpeed wanted, double seconds) {
        chosenRad = Double.NaN;
        waitedS = Math.max(0, waitedS - seconds);
        if (Math.abs(speedMps) >= SLOW_MPS) { // else it may only turn
            stoodS = 0;
        }
        return wanted;
    }

    private CourseAndSpeed giveWay(LineAhead along, double seconds) {
        line = new Course(along.courseRad());
        besideM = along.besideM();
        boolean waits = speedMps * heading.along(course) < courseMps / 5;
        waitedS = waits ? Math.min(LONGEST_WAIT_S, waitedS + seconds) : Math.max(0, waitedS - seconds);
        stoodS = waits ? stoodS + seconds : Math.max(0, stoodS - seconds);
        CourseAndSpeed best = best();
        chosenRad = best.courseRad();
        return best;
    }

    private CourseAndSpeed goBack(LineAhead along) {
        stoodS = 0;
        chosenRad = along.courseRad();
        isOnLine = false; // nobody has planned that line
        if (along.aheadM() == 0) {
            return new CourseAndSpeed(heading.rad(), 0);
        }
        course = new Course(along.courseRad());
        courseMps = ASIDE_MPS;
        line = course;
        besideM = 0;
        measureStopping(along);
        return best();
    }

    /** Whether the boat is on its line, and goes on along it: then that keeps it clear of what it is not to enter. */
    private boolean isOn(LineAhead along) {
        double nowM = along.besideM();
        double thenM =
                nowM + vehicle.speedMps() * StrictMath.sin(vehicle.headingRad() - along.courseRad()) * ON_LINE_AHEAD_S;
        return Math.abs(nowM) <= ON_LINE_M && Math.abs(thenM) <= ON_LINE_M;
    }

    private void forget() {
        chosenRad = Double.NaN;
        waitedS = 0;
        stoodS = 0;
        gaveWayS = 0;
        goingBack.end();
        last.forget();
    }

    // ---- who is there

    /**
     * Takes up where this boat is, what it is not to enter, and who can come near.
     *
     * @param fastestMps the most that this boat goes, whatever it chooses, in m/s
     */
    private void update(double fastestMps, boolean hasWay, long nowMs) {
        eastM = surroundings.plane().eastM(vehicle.latDeg(), vehicle.lonDeg());
        northM = surroundings.plane().northM(vehicle.latDeg(), vehicle.lonDeg());
        if (surroundings.border().isPast(eastM, northM)) {
            surroundings.forgetBorder();
        }
        border = surroundings.border();
        speedMps = vehicle.speedMps();
        double less = KEPT_LESS * Math.max(0, (gaveWayS - LONG_S) / (LONGEST_S - LONG_S));
        double keptM = APART_M + forErrorsM * (1 - less);
        neighbours.update(eastM, northM, speedMps, fastestMps, hasWay, keptM, nowMs);
    }

    /** Measures where the others can stop, and how far to keep off what is not to be entered, before it is asked what is safe. */
    private void measureStopping(LineAhead along) {
        Segment own = Stopping.segment(eastM, northM, heading, speedMps, 0);
        neighbours.measureStopping(eastM, northM, own);
        double soonM = Math.abs(Stopping.distanceM(speedMps, 2 * Stopping.REACTION_S)) + 1;
        border.measure(eastM, northM, own, along, soonM);
    }

    // ---- what is safe and what it costs

    /**
     * Whether the boat could still stop apart from all others and from what is not to be entered, had it gone so for a moment; where it is nearer already,
     * no nearer.
     *
     * @param followsLine whether its line keeps it clear of what is not to be entered
     */
    private boolean isSafe(Course direction, double atMps, boolean followsLine) {
        double turn = direction.turnFrom(heading.rad());
        double wantedMps = atMps * Math.max(0, direction.along(heading));
        double gain = GAINING_MPS2 * Stopping.REACTION_S;
        double thenMps = speedMps + clamped(wantedMps - speedMps, gain);
        Course least = leastTurn.after(direction, turn);
        Course farthest = leastTurn.allows(turn) ? least : farthestTurn.after(direction, turn);
        double wayM = (speedMps + thenMps) / 2 * Stopping.REACTION_S;
        double thenEastM = eastM + wayM * least.east();
        double thenNorthM = northM + wayM * least.north();
        return isClear(Stopping.segment(thenEastM, thenNorthM, least, thenMps, 0), followsLine)
                && (farthest == least
                        || isClear(Stopping.segment(thenEastM, thenNorthM, farthest, thenMps, 0), followsLine));
    }

    /** Whether a boat that hardly moves can go that way once it has turned, which it can on the spot. */
    private boolean isSafeOnceTurned(Course direction, boolean followsLine) {
        return isClear(Stopping.segment(eastM, northM, direction, ASTERN_MPS, Stopping.REACTION_S), followsLine);
    }

    private static double clamped(double value, double most) {
        return Math.max(-most, Math.min(most, value));
    }

    private boolean isClear(Segment own, boolean followsLine) {
        return neighbours.isClear(own) && (followsLine || border.allows(own));
    }

    /** The cheapest safe motion; to stop where none is safe. */
    private CourseAndSpeed best() {
        Course best = Math.abs(speedMps) > 0.3 ? heading : course;
        double bestMps = 0;
        double least = cost(best, bestMps, Double.MAX_VALUE);
        double fullMps = Math.max(courseMps, ASIDE_MPS);
        boolean turnsFirst = !border.isEmpty() && Math.abs(speedMps) < SLOW_MPS;
        for (Course offset : OFFSETS) {
            Course other = course.turned(offset);
            boolean followsLine = isOnLine && offset == OFFSETS[0];
            double toPort = offset.rad() < 0 ? TO_PORT : 0;
            for (double part : PARTS) {
                double mps = part * (Math.abs(offset.rad()) < ON_COURSE_RAD ? courseMps : fullMps);
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
        boolean astern = cost(heading, -ASTERN_MPS, least) < least && isSafeAstern();
        turns &= !astern;
        return astern ? new CourseAndSpeed(heading.rad(), -ASTERN_MPS) : new CourseAndSpeed(best.rad(), bestMps);
    }

    private boolean isSafeAstern() {
        return isClear(Stopping.segment(eastM, northM, heading, -ASTERN_MPS, Stopping.REACTION_S), false);
    }

    /** The cost of a motion; exact only where it is less than {@code leastCost}. */
    private double cost(Course direction, double mps, double leastCost) {
        double onward = mps * direction.along(course) / Math.max(courseMps, ASIDE_MPS);
        if (onward > 0 && waitedS > HELD_UP_S && neighbours.isBlocked(direction)) {
            onward = 0;
        }
        double thenM = Math.abs(besideM + mps * direction.across(line) * SOON_S);
        double patience = 1 / (1 + IMPATIENCE_PER_S * waitedS);
        double beside = patience * BESIDE_PER_M * Math.max(0, thenM - 0.5);
        double tooFar = thenM > FARTHEST_M && thenM > Math.abs(besideM) ? thenM - FARTHEST_M : 0;
        boolean waits = Math.abs(mps) < ASIDE_MPS / 4 || (mps < 0 && waitedS > HELD_UP_S); // to and fro is no way on
        double waiting = waits ? IMPATIENCE_PER_S * waitedS : 0;
        double turning = Double.isNaN(chosenRad) || mps <= 0
                ? 0
                : TURNING_BACK * Math.abs(direction.turnFrom(chosenRad)) / (Math.PI / 2);
        double withoutRisk = 1 - onward + beside + tooFar + waiting + turning;
        return withoutRisk < leastCost
                ? withoutRisk + neighbours.risk(direction, mps, leastCost - withoutRisk)
                : withoutRisk;
    }

    private static Course[] offsets(double... degrees) {
        return Arrays.stream(degrees)
                .mapToObj(offset -> new Course(Math.toRadians(offset)))
                .toArray(Course[]::new);
    }
}
