package org.sami.crw.sim.hull;

/** Finds out when a boat has lain at its quay long enough for a full battery. */
final class BatterySwap {
    private static final double STILL_MPS = 0.3;

    private final Quay quay;
    private boolean used;
    private double stillSeconds;

    BatterySwap(Quay quay) {
        this.quay = quay;
    }

    /** The boat has work to do: from now on its battery is somebody's concern. */
    void use() {
        used = true;
        stillSeconds = 0;
    }

    /** Lets time pass; true at the moment at which the battery is full. */
    boolean pass(double seconds, double eastM, double northM, double speedMps) {
        boolean still = Math.abs(speedMps) < STILL_MPS;
        used |= !still;
        if (!still || !quay.reaches(eastM, northM)) {
            stillSeconds = 0;
            return false;
        }
        stillSeconds += seconds;
        if (!used || stillSeconds < Quay.SWAP_SECONDS) {
            return false;
        }
        used = false;
        return true;
    }
}
