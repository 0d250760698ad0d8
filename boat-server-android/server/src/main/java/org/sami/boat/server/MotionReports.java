package org.sami.boat.server;

import org.sami.boat.link.BoatMode;
import org.sami.boat.link.Motion;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.boat.server.vehicle.PlaneMath;
import org.sami.boat.server.vehicle.Vehicle;

/**
 * Decides when the base is to be told how the boat moves, for others to give way: up to five times a second as long as it moves otherwise than they expect
 * by what it said last, which is straight on at the same speed, and once a second else (dead reckoning, as of IEEE 1278.1). For the thread that ticks the
 * server.
 */
final class MotionReports {
    private static final long LOOK_MS = 200;
    private static final long PERIOD_MS = 1000; // others take a boat to go straight on for 1.5 s

    // what others may err by, small beside the half metre that boats keep on top of 3 m
    private static final double OFF_M = 0.1;
    private static final double OFF_MPS = 0.05;
    private static final double SLOWEST_MPS =
            0.5; // of a slower boat the turn counts as of one that is so fast: it may go that way soon

    private final Vehicle vehicle;
    private long lookedMs = Long.MIN_VALUE / 2;
    private long saidMs = Long.MIN_VALUE / 2;
    private BoatMode mode = BoatMode.STOPPED; // this and what follows as it was said last
    private LocalFrame place = new LocalFrame(0, 0);
    private double headingRad;
    private double speedMps;

    /** Nothing was said yet. */
    MotionReports(Vehicle vehicle) {
        this.vehicle = vehicle;
    }

    /** Whether it is to be looked whether there is something to say. */
    boolean isLookDue(long nowMs) {
        return nowMs - lookedMs >= LOOK_MS;
    }

    /** Looks whether others expect the boat elsewhere by now, or otherwise under way, or have heard nothing for a while. */
    boolean isNews(BoatMode modeNow, long nowMs) {
        lookedMs = nowMs;
        return nowMs - saidMs >= PERIOD_MS || modeNow != mode || hasChangedMotion() || isElsewhere(nowMs);
    }

    private boolean hasChangedMotion() {
        double turnMps =
                PlaneMath.sameTurn(vehicle.headingRad() - headingRad) * Math.max(SLOWEST_MPS, Math.abs(speedMps));
        return !(Math.abs(vehicle.speedMps() - speedMps) <= OFF_MPS && Math.abs(turnMps) <= OFF_MPS);
    }

    private boolean isElsewhere(long nowMs) {
        double wayM = speedMps * (nowMs - saidMs) / 1000;
        double eastM = place.eastM(vehicle.latDeg(), vehicle.lonDeg()) - wayM * StrictMath.sin(headingRad);
        double northM = place.northM(vehicle.latDeg(), vehicle.lonDeg()) - wayM * StrictMath.cos(headingRad);
        return !(PlaneMath.length(eastM, northM) <= OFF_M);
    }

    /** What is said now. */
    Motion say(BoatMode modeNow, long nowMs) {
        saidMs = nowMs;
        mode = modeNow;
        place = new LocalFrame(vehicle.latDeg(), vehicle.lonDeg());
        headingRad = vehicle.headingRad();
        speedMps = vehicle.speedMps();
        return new Motion(vehicle.latDeg(), vehicle.lonDeg(), headingRad, speedMps, mode);
    }
}
