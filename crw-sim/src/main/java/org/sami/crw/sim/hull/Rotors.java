package org.sami.crw.sim.hull;

/**
 * The vertical motion of a copter: it climbs and descends at constant speeds to the altitude that was set. It takes off straight up, as autopilots do, so that copters
 * that are to fly at several altitudes have them before they come near each other. Metres above the place of the take-off.
 */
final class Rotors {
    private static final double AT_ALTITUDE_M = 0.5;

    /** Lower, it only climbs: it does not move over the ground. */
    private static final double FREE_M = 2;

    private final RotorConfig config;
    private double altM;
    private double wantedM;
    private boolean takesOff; // has not been at the altitude that was set since it left the ground

    /** Rotors at rest, on the ground. */
    Rotors(RotorConfig config) {
        this.config = config;
    }

    double altM() {
        return altM;
    }

    void setAltitude(double metres) {
        wantedM = Math.max(0, Math.min(config.ceilingM(), metres));
    }

    boolean isAtAltitude() {
        return wantedM == 0 ? altM == 0 : Math.abs(altM - wantedM) <= AT_ALTITUDE_M;
    }

    /** Whether it may move over the ground: it has taken off, and is high enough. */
    boolean isFree() {
        return altM >= FREE_M && !takesOff;
    }

    /** Lets time pass; without charge it sinks to the ground. Gives the charge in percent that this costs. */
    double step(double seconds, boolean charged) {
        double aimM = charged ? wantedM : 0;
        altM = aimM > altM
                ? Math.min(aimM, altM + config.climbMps() * seconds)
                : Math.max(aimM, altM - config.descentMps() * seconds);
        takesOff = altM == 0 || (takesOff && !isAtAltitude());
        return altM > 0 ? config.batteryPercentPerS() * seconds : 0;
    }
}
