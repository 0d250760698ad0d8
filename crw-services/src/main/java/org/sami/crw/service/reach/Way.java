package org.sami.crw.service.reach;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.sami.crw.service.water.Water;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/**
 * The way that a boat has to go.
 *
 * @param from position of the boat, if known
 * @param charge its battery's charge, if known
 * @param points in driving order
 * @param avoid no-go areas of plan and project, such as land
 * @param water where the boat may go; empty = everywhere
 */
public record Way(
        String boat,
        Optional<GeoPoint> from,
        Optional<Charge> charge,
        List<GeoPoint> points,
        List<GeoArea> avoid,
        Optional<Water> water) {
    /** A way in open water. */
    public Way(
            String boat, Optional<GeoPoint> from, Optional<Charge> charge, List<GeoPoint> points, List<GeoArea> avoid) {
        this(boat, from, charge, points, avoid, Optional.empty());
    }

    public Way {
        Objects.requireNonNull(boat, "boat");
        Objects.requireNonNull(from, "from");
        Objects.requireNonNull(charge, "charge");
        points = List.copyOf(points);
        avoid = List.copyOf(avoid);
        Objects.requireNonNull(water, "water");
    }
}
