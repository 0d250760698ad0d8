package org.sami.crw.operator.map;

import java.util.List;
import java.util.Optional;
import org.sami.crw.service.Geodesy;
import org.sami.spn.value.GeoPoint;

/** A part of the map between two parallels and two meridians, in degrees; does not span the antimeridian. Immutable. */
public record MapBounds(double southDeg, double westDeg, double northDeg, double eastDeg) {
    /** No part is smaller than this to each side of its middle, in metres: a single point has water around it. */
    private static final double LEAST_HALF_M = 25;

    /** So much of its size a part has around what it is about. */
    private static final double MARGIN = 0.1;

    /** The part around points, with a margin; empty where there is no point. */
    static Optional<MapBounds> around(List<GeoPoint> points) {
        if (points.isEmpty()) {
            return Optional.empty();
        }
        double south = points.stream().mapToDouble(GeoPoint::latDeg).min().orElseThrow();
        double north = points.stream().mapToDouble(GeoPoint::latDeg).max().orElseThrow();
        double west = points.stream().mapToDouble(GeoPoint::lonDeg).min().orElseThrow();
        double east = points.stream().mapToDouble(GeoPoint::lonDeg).max().orElseThrow();
        GeoPoint middle = GeoPoint.of((south + north) / 2, (west + east) / 2);
        GeoPoint least = Geodesy.offset(middle, LEAST_HALF_M, LEAST_HALF_M);
        double halfLat = Math.max((north - south) / 2 * (1 + 2 * MARGIN), least.latDeg() - middle.latDeg());
        double halfLon = Math.max((east - west) / 2 * (1 + 2 * MARGIN), least.lonDeg() - middle.lonDeg());
        return Optional.of(new MapBounds(
                middle.latDeg() - halfLat,
                middle.lonDeg() - halfLon,
                middle.latDeg() + halfLat,
                middle.lonDeg() + halfLon));
    }

    /** The smallest part that has both. */
    MapBounds and(MapBounds other) {
        return new MapBounds(
                Math.min(southDeg, other.southDeg),
                Math.min(westDeg, other.westDeg),
                Math.max(northDeg, other.northDeg),
                Math.max(eastDeg, other.eastDeg));
    }

    /** What both have; empty where they do not overlap. */
    Optional<MapBounds> within(MapBounds other) {
        MapBounds common = new MapBounds(
                Math.max(southDeg, other.southDeg),
                Math.max(westDeg, other.westDeg),
                Math.min(northDeg, other.northDeg),
                Math.min(eastDeg, other.eastDeg));
        boolean overlap = common.southDeg < common.northDeg && common.westDeg < common.eastDeg;
        return overlap ? Optional.of(common) : Optional.empty();
    }
}
