package org.sami.mavlink.vehicle;

/**
 * A value of a sensor of a vehicle. Immutable.
 *
 * @param name {@code depth}, {@code temperature}, {@code distance}, {@code range}, or the name that the vehicle gives it
 * @param unit {@code m} or {@code °C}; empty where the vehicle names no unit
 */
public record VehicleReading(String name, double value, String unit) {}
