package org.sami.boat.server.traffic;

/**
 * What a boat chose last among others, and for how long that stays in force: others tell of themselves five times a second, so between that there is
 * nothing new to choose by. For one thread.
 */
final class LastChoice {
    /** At ticks of 100 ms each second one chooses anew; half a tick is left for ticks that are not quite on time. */
    private static final long IN_FORCE_MS = 150;

    private static final double SAME =
            StrictMath.cos(Math.toRadians(10)); // of the turn between courses that are nearly one

    private CourseAndSpeed wanted = new CourseAndSpeed(0, 0);
    private CourseAndSpeed chosen = wanted;
    private boolean hadWay;
    private long atMs = Long.MIN_VALUE / 2;
    private double sinceS;

    /** Whether it is new enough, and the boat still wants to go where it wanted to then. */
    boolean isInForce(CourseAndSpeed nowWanted, boolean hasWay, long nowMs) {
        return nowMs - atMs < IN_FORCE_MS
                && hasWay == hadWay
                && nowWanted.course().along(wanted.course()) > SAME;
    }

    /** It has been in force for so much longer, in seconds. */
    void lasts(double seconds) {
        sinceS += seconds;
    }

    /** For how long it has been in force, in seconds. */
    double sinceS() {
        return sinceS;
    }

    CourseAndSpeed chosen() {
        return chosen;
    }

    /** The boat has chosen now. */
    void set(CourseAndSpeed nowWanted, boolean hasWay, CourseAndSpeed nowChosen, long nowMs) {
        wanted = nowWanted;
        hadWay = hasWay;
        chosen = nowChosen;
        atMs = nowMs;
        sinceS = 0;
    }

    /** Nobody is there to choose among. */
    void forget() {
        atMs = Long.MIN_VALUE / 2;
        sinceS = 0;
    }
}
