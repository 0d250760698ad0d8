package org.sami.crw.sim.hull;

/** Finds out when a boat has lain at its quay long enough for a full battery. */
final class BatterySwap {
    private static final double STILL_MPS = 0.3;

    private final Quay quay;
    private boolean cameBack;
    private boolean away;
    private double stillSeconds;

    BatterySwap(Quay quay) {
        this.quay = quay;
    }

    /** Lets time pass; true at the moment at which the battery is full. */
    boolean pass(double seconds, double eastM, double northM, double speedMps) {
        if (!quay.reaches(eastM, northM)) {
            away = true;
            stillSeconds = 0;
            return false;
        }
        cameBack |= away;
        away = false;
        stillSeconds = Math.abs(speedMps) < STILL_MPS ? stillSeconds + seconds : 0;
        if (!cameBack || stillSeconds < Quay.SWAP_SECONDS) {
            return false;
        }
        cameBack = false;
        return true;
    }
}
