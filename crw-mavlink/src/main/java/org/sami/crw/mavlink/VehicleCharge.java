package org.sami.crw.mavlink;

import java.util.Optional;
import org.sami.boat.link.BatteryDefaults;
import org.sami.boat.link.BatteryLevel;
import org.sami.boat.link.BatteryReport;
import org.sami.mavlink.vehicle.VehicleBattery;
import org.sami.mavlink.vehicle.VehicleSnapshot;

/**
 * A vehicle's charge, as boats report theirs. Autopilots without a current sensor compute no percentage: of these only their own battery failsafe tells, which counts as
 * 0 % and critical. For the gateway's thread.
 */
final class VehicleCharge {
    private static final double FULL = 100;
    private static final double EMPTY = 0;
    private static final String UNKNOWN =
            "its autopilot computes none, as without a current sensor: only its own battery failsafe tells";

    private Optional<Double> percent = Optional.empty();
    private boolean isHeard; // of its battery
    private boolean isComputed; // it has reported a percentage
    private boolean isFailing; // in the last report
    private boolean wasFailing; // without a percentage: the base still has it for critical

    /** This is how the vehicle reports itself; whether it is another than before that it reports no charge. */
    boolean reported(VehicleSnapshot vehicle) {
        boolean before = unknown().isPresent();
        percent = vehicle.battery().flatMap(VehicleBattery::percent).map(Integer::doubleValue);
        isHeard |= vehicle.battery().isPresent();
        isComputed |= percent.isPresent();
        return before != unknown().isPresent();
    }

    /**
     * What is to be told of it; none where the autopilot computes no percentage and its failsafe has not acted. After a failsafe without a percentage it counts as full
     * once its autopilot has started again and finds its battery above its limits.
     *
     * @param failsafe whether its battery failsafe has acted: its battery is critical then, whatever the number
     */
    Optional<BatteryReport> report(boolean failsafe) {
        isFailing = failsafe;
        wasFailing |= failsafe && percent.isEmpty();
        if (percent.isEmpty() && !wasFailing) {
            return Optional.empty();
        }
        double told = percent();
        return Optional.of(new BatteryReport(
                told,
                failsafe
                        ? BatteryLevel.CRITICAL
                        : BatteryLevel.of(told, BatteryDefaults.LOW_PERCENT, BatteryDefaults.CRITICAL_PERCENT)));
    }

    /** In percent, by the last report; bases read it only where a report has come. */
    double percent() {
        return percent.orElse(isFailing ? EMPTY : FULL);
    }

    /** Why it reports no charge; empty where it does, or where nothing was heard of its battery yet. */
    Optional<String> unknown() {
        return isHeard && !isComputed ? Optional.of(UNKNOWN) : Optional.empty();
    }
}
