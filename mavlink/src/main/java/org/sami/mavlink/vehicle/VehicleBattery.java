package org.sami.mavlink.vehicle;

import java.util.Optional;

/**
 * A vehicle's battery.
 *
 * @param volts empty where it is not measured
 * @param percent what is left, 0 to 100; empty where the autopilot does not compute it
 */
public record VehicleBattery(Optional<Double> volts, Optional<Integer> percent) {}
