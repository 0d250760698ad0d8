package org.sami.crw.sim.run.record;

import java.util.Objects;

/**
 * A boat: in process its true state, over TCP the last reported one.
 *
 * @param eastM metres east of the area's centre
 * @param northM metres north of the area's centre
 * @param batteryPercent charge left, 0 to 100
 * @param distanceM metres driven since the start
 * @param altM metres above the place of the take-off; 0 for what does not fly
 */
public record BoatState(
        String id,
        double eastM,
        double northM,
        double latDeg,
        double lonDeg,
        double speedMps,
        double batteryPercent,
        double distanceM,
        int recharges,
        double altM) {
    public BoatState {
        Objects.requireNonNull(id, "id");
    }

    /** Where it is, in whole millimetres east and north. */
    String toTheMillimetre() {
        return Math.round(eastM * 1000) + " " + Math.round(northM * 1000);
    }
}
