package org.sami.mavlink.vehicle;

import java.util.Optional;

/**
 * Where a vehicle says that it is.
 *
 * @param latDeg degrees north, WGS 84
 * @param lonDeg degrees east, WGS 84
 * @param heightM metres over where it was armed or switched on
 * @param speedMps over ground, metres a second
 * @param headingDeg where its bow points, degrees from true north clockwise; empty where it does not know
 * @param heardMs when it said so, on the base's clock
 * @param bootMs when it was there, on its own clock: since its autopilot was switched on, in ms
 */
public record VehiclePosition(
        double latDeg,
        double lonDeg,
        double heightM,
        double speedMps,
        Optional<Double> headingDeg,
        long heardMs,
        long bootMs) {}
