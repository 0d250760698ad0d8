package org.sami.boat.hull.position;

import java.util.EnumSet;
import java.util.Optional;
import java.util.Set;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.boat.server.vehicle.PlaneMath;

/**
 * Position, heading and speed from GPS, compass, gyro and motors. Times are those of one clock that never runs back, at which a measurement arrived: what the
 * receiver or the phone holds for the date does not matter.
 *
 * <p>Positions at 0,0, beyond 85 degrees of latitude, worse than {@link #WORST_ACCURACY_M} or no numbers are refused. A fix far from the estimate is refused,
 * too, until three seconds of them agree with one another: then the boat is there. Without fixes the position is extrapolated for {@link #GPS_LOST_AFTER_MS}, with
 * an error that grows, and is unknown afterwards. Safe for use by several threads.
 */
public final class PositionFilter {
    /** After so long without a fix the position is unknown. */
    public static final long GPS_LOST_AFTER_MS = 10_000;

    /** Fixes with a larger error are refused. */
    public static final double WORST_ACCURACY_M = 50;

    private static final long GAP_MS = 2000;
    private static final long COMPASS_LOST_MS = 3000;
    private static final long GYRO_LOST_MS = 500;
    private static final long MOTORS_LOST_MS = 1000;
    private static final double USUAL_ACCURACY_M = 2;
    private static final double LEAST_ACCURACY_M = 1;
    private static final double CORRELATED = 2.5; // fixes 0.2 s apart share most of their error
    private static final double CORRELATED_S = 0.2;
    private static final double REPEATED = 3; // the receiver has nothing new
    private static final double MOTION_ERROR_MPS = 0.25;
    private static final double MAX_SPEED_MPS = 20;
    private static final double JUMP_DEVIATIONS = 4;
    private static final double LEAST_JUMP_M = 8;
    private static final long JUMP_STAYS_MS = 3000;
    private static final double FRAME_M = 5000;
    private static final double LONGEST_STEP_S = 10;

    private final CourseCheck courses = new CourseCheck();
    private HeadingEstimate heading = new HeadingEstimate();
    private Optional<LocalFrame> frame = Optional.empty();
    private TrackEstimate track = new TrackEstimate(0, 0, 1);
    private double declinationRad;
    private double gyroRadPerS;
    private double motorTurnRadPerS;
    private double thrust = Double.NaN;
    private long passedMs = Long.MIN_VALUE;
    private long fixMs = Long.MIN_VALUE / 2;
    private long refusedMs = Long.MIN_VALUE / 2;
    private long jumpSinceMs;
    private long compassMs = Long.MIN_VALUE / 2;
    private long gyroMs = Long.MIN_VALUE / 2;
    private long motorMs = Long.MIN_VALUE / 2;
    private Optional<GpsFix> jump = Optional.empty();
    private long refused;
    private double lastLatDeg = Double.NaN; // of the last fix that counted
    private double lastLonDeg = Double.NaN;

    /** Magnetic declination at the place: true north minus magnetic, in radians, positive to the east. */
    public synchronized void setDeclination(double radians) {
        if (Math.abs(radians) <= Math.PI) {
            declinationRad = radians;
        }
    }

    /**
     * What the motors do to the hull where there is no gyro.
     *
     * @param thrustAhead -1 to 1; a hull that does not drive ahead has no heading by its course
     * @param turnRadPerS turn rate that it should have, to starboard
     */
    public synchronized void motors(double thrustAhead, double turnRadPerS, long nowMs) {
        motorMs = pass(nowMs);
        thrust = thrustAhead;
        motorTurnRadPerS = turnRadPerS;
    }

    /** The compass shows a heading from magnetic north, in radians. */
    public synchronized void compass(double magneticRad, long nowMs) {
        trueCompass(magneticRad + declinationRad, nowMs);
    }

    /** The compass shows a heading from true north, in radians. */
    public synchronized void trueCompass(double rad, long nowMs) {
        if (Math.abs(rad) <= 4 * Math.PI) {
            compassMs = pass(nowMs);
            double shown = PlaneMath.sameTurn(rad);
            heading.compass(shown);
            courses.compass(shown);
        }
    }

    /** The gyro measures a turn rate in radians a second, to starboard. */
    public synchronized void gyro(double radPerS, long nowMs) {
        if (Math.abs(radPerS) <= 10) {
            gyroMs = pass(nowMs);
            gyroRadPerS = radPerS;
        }
    }

    /** The receiver gives a position. */
    public synchronized void gps(GpsFix fix, long nowMs) {
        long atMs = pass(nowMs);
        if (!isPlausible(fix)) {
            refuse(atMs);
        } else if (!frame.isPresent() || atMs - fixMs > GPS_LOST_AFTER_MS) {
            begin(fix, atMs);
        } else if (isJump(fix, frame.get())) {
            jumped(fix, atMs);
        } else {
            jump = Optional.empty();
            correct(fix, frame.get(), atMs);
        }
    }

    private static boolean isPlausible(GpsFix fix) {
        boolean nowhere = Math.abs(fix.latDeg()) < 1e-4 && Math.abs(fix.lonDeg()) < 1e-4;
        boolean there = Math.abs(fix.latDeg()) <= 85 && Math.abs(fix.lonDeg()) <= 180;
        return there && !nowhere && !(fix.accuracyM() > WORST_ACCURACY_M) && !(fix.speedMps() > MAX_SPEED_MPS);
    }

    private void refuse(long nowMs) {
        refused++;
        refusedMs = nowMs;
    }

    private static double errorM(GpsFix fix) {
        double given = fix.accuracyM() > 0 ? fix.accuracyM() : USUAL_ACCURACY_M;
        return Math.max(LEAST_ACCURACY_M, given);
    }

    private void begin(GpsFix fix, long nowMs) {
        frame = Optional.of(new LocalFrame(fix.latDeg(), fix.lonDeg()));
        track = new TrackEstimate(0, 0, errorM(fix));
        jump = Optional.empty();
        fixMs = nowMs;
        motion(fix);
    }

    private boolean isJump(GpsFix fix, LocalFrame plane) {
        if (plane.distanceM(fix.latDeg(), fix.lonDeg()) > 4 * FRAME_M) {
            return true;
        }
        double eastM = plane.eastM(fix.latDeg(), fix.lonDeg());
        double northM = plane.northM(fix.latDeg(), fix.lonDeg());
        return Math.hypot(eastM - track.eastM(), northM - track.northM()) > LEAST_JUMP_M
                && track.deviations(eastM, northM, errorM(fix)) > JUMP_DEVIATIONS;
    }

    /** A fix far away counts once three seconds of them agree. */
    private void jumped(GpsFix fix, long nowMs) {
        refuse(nowMs);
        boolean agrees = jump.isPresent()
                && new LocalFrame(jump.get().latDeg(), jump.get().lonDeg()).distanceM(fix.latDeg(), fix.lonDeg())
                        < LEAST_JUMP_M + MAX_SPEED_MPS * (nowMs - jumpSinceMs) / 1000.0 / 4;
        if (!agrees) {
            jump = Optional.of(fix);
            jumpSinceMs = nowMs;
        } else if (nowMs - jumpSinceMs >= JUMP_STAYS_MS) {
            begin(fix, nowMs);
        }
    }

    private void correct(GpsFix fix, LocalFrame plane, long nowMs) {
        double seconds = Math.max(CORRELATED_S, (nowMs - fixMs) / 1000.0);
        double error = errorM(fix) * Math.max(1, CORRELATED * Math.sqrt(CORRELATED_S / seconds));
        if (fix.latDeg() == lastLatDeg && fix.lonDeg() == lastLonDeg) {
            error *= REPEATED;
        }
        lastLatDeg = fix.latDeg();
        lastLonDeg = fix.lonDeg();
        track.position(plane.eastM(fix.latDeg(), fix.lonDeg()), plane.northM(fix.latDeg(), fix.lonDeg()), error);
        fixMs = nowMs;
        motion(fix);
        double eastMps = track.eastMps(heading.headingRad());
        double northMps = track.northMps(heading.headingRad());
        boolean measured = !Double.isNaN(fix.speedMps() + fix.courseRad());
        double speed = measured ? fix.speedMps() : Math.hypot(eastMps, northMps);
        double course = measured ? PlaneMath.sameTurn(fix.courseRad()) : StrictMath.atan2(eastMps, northMps);
        if (measured || !hasCompass(nowMs)) {
            if (courses.isHeading(speed, thrust)) {
                heading.course(course, CourseCheck.errorRad(speed));
            }
            if (courses.course(speed, course, thrust, nowMs)) {
                heading.doubtCompass();
            }
        }
        keepNear(plane);
    }

    private void motion(GpsFix fix) {
        if (fix.speedMps() >= 0 && Math.abs(fix.courseRad()) <= 4 * Math.PI) {
            double east = fix.speedMps() * Math.sin(fix.courseRad());
            double north = fix.speedMps() * Math.cos(fix.courseRad());
            track.motion(east, north, heading.headingRad(), heading.isKnown(), MOTION_ERROR_MPS);
        }
    }

    private void keepNear(LocalFrame plane) {
        if (Math.hypot(track.eastM(), track.northM()) > FRAME_M) {
            double lat = plane.latDeg(track.eastM(), track.northM());
            double lon = plane.lonDegOn(lat, track.eastM());
            frame = Optional.of(new LocalFrame(lat, lon));
            track.shift(-track.eastM(), -track.northM());
        }
    }

    private boolean hasCompass(long nowMs) {
        return nowMs - compassMs <= COMPASS_LOST_MS;
    }

    /** Lets time pass up to now, and returns the time: what comes with an earlier one counts for the newest. */
    private long pass(long nowMs) {
        double seconds = passedMs == Long.MIN_VALUE ? 0 : Math.min(LONGEST_STEP_S, (nowMs - passedMs) / 1000.0);
        if (seconds <= 0) {
            passedMs = Math.max(passedMs, nowMs);
            return passedMs;
        }
        passedMs = nowMs;
        boolean gyro = nowMs - gyroMs <= GYRO_LOST_MS;
        boolean motors = nowMs - motorMs <= MOTORS_LOST_MS;
        heading.turn(gyro ? gyroRadPerS : motors ? motorTurnRadPerS : 0, gyro, seconds);
        track.pass(heading.headingRad(), heading.isKnown() ? heading.errorRad() : Double.NaN, seconds);
        return passedMs;
    }

    /** Where the hull is now. Without a compass its heading is unknown until it moves, or {@link #assumeHeading} was called. */
    public synchronized Pose pose(long nowMs) {
        long atMs = pass(nowMs);
        if (!frame.isPresent() || atMs - fixMs > GPS_LOST_AFTER_MS) {
            return heading.isKnown()
                    ? new Pose(Double.NaN, Double.NaN, heading.headingRad(), Double.NaN, Double.NaN, heading.errorRad())
                    : Pose.UNKNOWN;
        }
        double lat = frame.get().latDeg(track.eastM(), track.northM());
        double lon = frame.get().lonDegOn(lat, track.eastM());
        if (!heading.isKnown()) {
            double speed = Math.hypot(track.eastMps(0), track.northMps(0));
            return new Pose(lat, lon, Double.NaN, speed, track.errorM(), Double.NaN);
        }
        double rad = heading.headingRad();
        double along = track.eastMps(rad) * Math.sin(rad) + track.northMps(rad) * Math.cos(rad);
        return new Pose(lat, lon, rad, along, track.errorM(), heading.errorRad());
    }

    /** Assumes north as heading, so that a boat without a compass can begin to move and find its heading by its course. */
    public synchronized void assumeHeading() {
        if (!heading.isKnown()) {
            heading.assumeNorth();
        }
    }

    /** What is doubtful now. */
    public synchronized Set<PositionDoubt> doubts(long nowMs) {
        Set<PositionDoubt> doubts = EnumSet.noneOf(PositionDoubt.class);
        if (nowMs - fixMs > GAP_MS) {
            doubts.add(PositionDoubt.NO_GPS);
        }
        if (nowMs - refusedMs <= GAP_MS) {
            doubts.add(PositionDoubt.GPS_IMPLAUSIBLE);
        }
        if (!hasCompass(nowMs)) {
            doubts.add(PositionDoubt.NO_COMPASS);
        } else if (courses.disagrees()) {
            doubts.add(PositionDoubt.COMPASS_DISAGREES);
        }
        return doubts;
    }

    /** By how much compass and course disagreed lately, in radians, compass minus course; NaN before the hull has moved. */
    public synchronized double disagreementRad() {
        return courses.disagreementRad();
    }

    /** How many fixes were refused. */
    public synchronized long refusedFixes() {
        return refused;
    }
}
