package org.sami.boat.server;

import java.util.Optional;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.Motion;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.boat.server.vehicle.PlaneMath;
import org.sami.boat.server.vehicle.Vehicle;

/**
 * Decides when the boat reports its motion to the base, so that others can give way: up to five times a second while it deviates from what others
 * predict by its last report (straight on at the same speed), otherwise once a second (dead reckoning, as in IEEE 1278.1). For the thread that ticks
 * the server.
 */
final class MotionReports {
    private static final long CHECK_MS = 200;
    private static final long PERIOD_MS = 1000; // others predict a boat for 1.5 s

    // largest errors of the prediction; small against the half metre that boats keep in addition to 3 m
    private static final double TOLERANCE_M = 0.1;
    private static final double TOLERANCE_MPS = 0.05;

    /** A slower boat's turn counts as at this speed: it may soon go that way. */
    private static final double LEAST_TURN_SPEED_MPS = 0.5;

    private static final double NEAR_M = 20;
    private static final double STILL_MPS = 0.05;

    private final Vehicle vehicle;
    private final ModeControl modes;
    private long checkedMs = Long.MIN_VALUE / 2;
    private long reportedMs = Long.MIN_VALUE / 2;
    private BoatMode mode = BoatMode.STOPPED; // this and the following as last reported
    private LocalFrame place = new LocalFrame(0, 0);
    private double headingRad;
    private double speedMps;

    /** Nothing is reported yet. */
    MotionReports(Vehicle vehicle, ModeControl modes) {
        this.vehicle = vehicle;
        this.modes = modes;
    }

    /** The report of this moment, where the base needs one: while the boat moves near others. The boat knows where it is. */
    Optional<Motion> due(long nowMs) {
        boolean needed = !modes.surroundings().isEmpty()
                && nowMs - checkedMs >= CHECK_MS
                && isNews(modes.mode(), nowMs)
                && isMovingNearOthers(nowMs);
        return needed ? Optional.of(report(modes.mode(), nowMs)) : Optional.empty();
    }

    private boolean isMovingNearOthers(long nowMs) {
        boolean rests = modes.mode() != BoatMode.PATH && Math.abs(vehicle.speedMps()) < STILL_MPS;
        return !rests && modes.surroundings().isNear(vehicle.latDeg(), vehicle.lonDeg(), NEAR_M, nowMs);
    }

    /** Checks whether others predict the boat at another place or in another mode, or have had no report for a while. */
    private boolean isNews(BoatMode modeNow, long nowMs) {
        checkedMs = nowMs;
        return nowMs - reportedMs >= PERIOD_MS || modeNow != mode || hasChangedMotion() || isElsewhere(nowMs);
    }

    private boolean hasChangedMotion() {
        double turnMps = PlaneMath.sameTurn(vehicle.headingRad() - headingRad)
                * Math.max(LEAST_TURN_SPEED_MPS, Math.abs(speedMps));
        return !(Math.abs(vehicle.speedMps() - speedMps) <= TOLERANCE_MPS && Math.abs(turnMps) <= TOLERANCE_MPS);
    }

    private boolean isElsewhere(long nowMs) {
        double wayM = speedMps * (nowMs - reportedMs) / 1000;
        double eastM = place.eastM(vehicle.latDeg(), vehicle.lonDeg()) - wayM * StrictMath.sin(headingRad);
        double northM = place.northM(vehicle.latDeg(), vehicle.lonDeg()) - wayM * StrictMath.cos(headingRad);
        return !(PlaneMath.length(eastM, northM) <= TOLERANCE_M);
    }

    private Motion report(BoatMode modeNow, long nowMs) {
        reportedMs = nowMs;
        mode = modeNow;
        place = new LocalFrame(vehicle.latDeg(), vehicle.lonDeg());
        headingRad = vehicle.headingRad();
        speedMps = vehicle.speedMps();
        return new Motion(vehicle.latDeg(), vehicle.lonDeg(), headingRad, speedMps, mode);
    }
}
