package org.sami.boat.hull.settings;

/** Drives motors for a test, while the boat server commands nothing. */
public interface MotorDrive {
    /**
     * Drives for a time, instead of what was being tested before; 0 ends it.
     *
     * @param port effort of the port motor, -1 to 1
     * @param starboard effort of the starboard motor, -1 to 1
     * @return whether it does: not while the board is gone, or the boat server moves the boat
     */
    boolean drive(double port, double starboard, long forMs);
}
