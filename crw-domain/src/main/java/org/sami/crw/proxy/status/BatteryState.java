package org.sami.crw.proxy.status;

import org.sami.boat.link.BatteryLevel;
import org.sami.boat.link.BoatPerformance;
import org.sami.crw.service.reach.Charge;
import org.sami.crw.service.reach.Range;

/**
 * What a boat said of its battery.
 *
 * @param percent charge in percent of full
 * @param level the class that the boat puts it in
 */
public record BatteryState(double percent, BatteryLevel level) {
    /** The charge of a boat that drives so, at its usual speed; one that does not say how far a percent takes it has the usual range. */
    public Charge charge(BoatPerformance performance) {
        return new Charge(percent, performance.metresPerPercent().orElse(Range.METRES_PER_PERCENT));
    }

    /** The same of a boat that drives at a speed in m/s, which may cost more or less, and comes home at its usual one. */
    public Charge charge(BoatPerformance performance, double speedMps) {
        return charge(performance)
                .outward(performance.metresPerPercent(speedMps).orElse(Range.METRES_PER_PERCENT));
    }
}
