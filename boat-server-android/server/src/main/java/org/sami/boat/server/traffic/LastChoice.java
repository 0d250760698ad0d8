package org.sami.boat.server.traffic;

/**
 * The last choice of {@link GivingWay}, and how long it stays in force: other boats report five times a second, and a choice between two reports would
 * have nothing new to go by. For one thread.
 */
final class LastChoice {
    /** With ticks of 100 ms every second one chooses; half a tick allows for ticks that are not quite on time. */
    private static final long IN_FORCE_MS = 150;

    /** Cosine of the largest turn between two intended courses that count as the same. */
    private static final double SAME_COURSE_COSINE = StrictMath.cos(Math.toRadians(10));

    private CourseAndSpeed wanted = new CourseAndSpeed(0, 0);
    private CourseAndSpeed chosen = wanted;
    private boolean hadWay;
    private long atMs = Long.MIN_VALUE / 2;
    private double sinceS;

    /** Whether the choice is recent enough and the boat still intends the same course. */
    boolean isInForce(CourseAndSpeed nowWanted, boolean hasWay, long nowMs) {
        return nowMs - atMs < IN_FORCE_MS
                && hasWay == hadWay
                && nowWanted.course().along(wanted.course()) > SAME_COURSE_COSINE;
    }

    /** Adds to the time for which the choice has been in force, in seconds. */
    void lasts(double seconds) {
        sinceS += seconds;
    }

    /** How long the choice has been in force, in seconds. */
    double sinceS() {
        return sinceS;
    }

    CourseAndSpeed chosen() {
        return chosen;
    }

    /** Records a choice that was made now. */
    void set(CourseAndSpeed nowWanted, boolean hasWay, CourseAndSpeed nowChosen, long nowMs) {
        wanted = nowWanted;
        hadWay = hasWay;
        chosen = nowChosen;
        atMs = nowMs;
        sinceS = 0;
    }

    /** Forgets the choice: no other boat is near. */
    void forget() {
        atMs = Long.MIN_VALUE / 2;
        sinceS = 0;
    }
}
