package org.sami.ui.geo;

import java.util.Collection;
import java.util.List;
import java.util.Optional;
import org.sami.spn.value.GeoPoint;

/** The smallest box of latitudes and longitudes around some points, in degrees; it does not span the date line. */
public record GeoBounds(double southDeg, double westDeg, double northDeg, double eastDeg) {
    public GeoBounds {
        if (!(southDeg <= northDeg && westDeg <= eastDeg)) {
            throw new IllegalArgumentException(
                    "The south of a box is below its north and its west left of its east, not " + southDeg + ", "
                            + westDeg + ", " + northDeg + ", " + eastDeg);
        }
    }

    /** The box around points; none where there is no point. */
    public static Optional<GeoBounds> of(Collection<GeoPoint> points) {
        return points.stream()
                .map(p -> new GeoBounds(p.latDeg(), p.lonDeg(), p.latDeg(), p.lonDeg()))
                .reduce(GeoBounds::with);
    }

    /** The box around this one and another. */
    public GeoBounds with(GeoBounds other) {
        return new GeoBounds(
                Math.min(southDeg, other.southDeg),
                Math.min(westDeg, other.westDeg),
                Math.max(northDeg, other.northDeg),
                Math.max(eastDeg, other.eastDeg));
    }

    /** Whether a point lies in it or on its rim. */
    public boolean contains(GeoPoint point) {
        return point.latDeg() >= southDeg
                && point.latDeg() <= northDeg
                && point.lonDeg() >= westDeg
                && point.lonDeg() <= eastDeg;
    }

    /** The north-western and the south-eastern corner. */
    public List<GeoPoint> corners() {
        return List.of(GeoPoint.of(northDeg, westDeg), GeoPoint.of(southDeg, eastDeg));
    }
}
