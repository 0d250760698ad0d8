package org.sami.crw.sim.hull;

import org.sami.boat.server.vehicle.PlaneMath;

/**
 * Finds out when a boat has lain at its quay long enough for a full battery. A boat that comes to rest there, in the water or, where
 * current and wind have it drive to keep its place, over ground, is taken hold of, and lies there as long as it does not leave. Nobody takes hold of
 * a boat that is under way, though it may wait at the quay for others to pass.
 */
final class BatterySwap {
    private static final double REST_SPEED_MPS = 0.3;

    /** A boat that is taken hold of sways; one that goes farther than this, in metres, has left. */
    private static final double RELEASE_DISTANCE_M = 8;

    private final Quay quay;
    private boolean used;
    private boolean isHeld;
    private double heldEastM;
    private double heldNorthM;
    private double lastEastM = Double.NaN;
    private double lastNorthM = Double.NaN;
    private double stillSeconds;

    BatterySwap(Quay quay) {
        this.quay = quay;
    }

    /** The boat has work to do: from now on its battery is somebody's concern. */
    void use() {
        used = true;
        isHeld = false;
    }

    /**
     * Lets time pass; true at the moment at which the battery is full.
     *
     * @param underWay whether the boat has a way to go now
     */
    boolean pass(double seconds, double eastM, double northM, double speedMps, boolean underWay) {
        boolean still = Math.abs(speedMps) < REST_SPEED_MPS;
        used |= !still && !isHeld; // who is held and sways has not left
        still |= PlaneMath.length(eastM - lastEastM, northM - lastNorthM) < REST_SPEED_MPS * seconds;
        lastEastM = eastM;
        lastNorthM = northM;
        boolean reached = quay.reaches(eastM, northM);
        if (underWay) {
            isHeld = false;
        } else if (isHeld) {
            isHeld = reached && PlaneMath.length(eastM - heldEastM, northM - heldNorthM) <= RELEASE_DISTANCE_M;
        } else if (reached && still) {
            isHeld = true;
            heldEastM = eastM;
            heldNorthM = northM;
            stillSeconds = 0;
        }
        if (!isHeld) {
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
