package org.sami.crw.proxy.status;

import org.sami.spn.value.GeoPoint;

/**
 * Where a boat said it was.
 *
 * @param position WGS 84
 * @param headingRad radians clockwise from true north
 * @param speedMps speed in m/s along the heading, negative astern
 * @param boatTimeMs the boat's clock at that moment
 */
public record BoatPose(GeoPoint position, double headingRad, double speedMps, long boatTimeMs) {}
