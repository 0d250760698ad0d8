package org.sami.crw.service.coverage;

import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.sami.crw.service.water.CrossTrackError;
import org.sami.crw.service.water.Water;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/**
 * A problem of covering an area.
 *
 * @param boats the position of each boat, empty where unknown
 * @param area a simple polygon, concave or not, with or without holes; holes are no-go areas
 * @param spacingM distance between two lanes, more than zero: a point is covered when the track passes within half of it
 * @param avoid no-go areas, also on the boats' way to the area
 * @param within the area to stay in, if there is one, also on the way
 * @param error how far boats may be off their tracks: tracks keep that distance from no-go areas
 * @param ranges how far the boats' charges last
 * @param speedsMps the boats' speeds on their tracks, in m/s; a boat whose speed is not known is missing, and as fast as the fastest
 * @param turningRadiiM radii of the boats' narrowest turns, in metres; a boat that turns on the spot, or of which it is not known, is missing
 */
public record CoverageProblem(
        Map<String, Optional<GeoPoint>> boats,
        GeoArea area,
        double spacingM,
        List<GeoArea> avoid,
        Optional<GeoArea> within,
        CrossTrackError error,
        Ranges ranges,
        Map<String, Double> speedsMps,
        Map<String, Double> turningRadiiM) {
    /** A boat that has left an area is at least this far from it, in metres. */
    private static final double LEAST_CLEARANCE_M = 0.1;

    public CoverageProblem {
        Objects.requireNonNull(ranges, "ranges");
        Objects.requireNonNull(error, "error");
        boats = Collections.unmodifiableMap(new LinkedHashMap<>(boats));
        Objects.requireNonNull(area, "area");
        avoid = List.copyOf(avoid);
        speedsMps = Map.copyOf(speedsMps);
        turningRadiiM = Map.copyOf(turningRadiiM);
        Objects.requireNonNull(within, "within");
        if (boats.isEmpty()) {
            throw new IllegalArgumentException("There is no boat to cover the area");
        }
        if (!(spacingM >= 0.1) || spacingM > 10_000) {
            throw new IllegalArgumentException("The spacing is at least 0.1 m and at most 10 km, not " + spacingM);
        }
    }

    /** An area for boats of one speed. */
    public CoverageProblem(
            Map<String, Optional<GeoPoint>> boats,
            GeoArea area,
            double spacingM,
            List<GeoArea> avoid,
            Optional<GeoArea> within,
            CrossTrackError error,
            Ranges ranges) {
        this(boats, area, spacingM, avoid, within, error, ranges, Map.of(), Map.of());
    }

    /** An area for boats of which is not known how far they get. */
    public CoverageProblem(
            Map<String, Optional<GeoPoint>> boats,
            GeoArea area,
            double spacingM,
            List<GeoArea> avoid,
            Optional<GeoArea> within,
            CrossTrackError error) {
        this(boats, area, spacingM, avoid, within, error, Ranges.UNKNOWN);
    }

    /** An area for boats that are where their tracks are. */
    public CoverageProblem(
            Map<String, Optional<GeoPoint>> boats,
            GeoArea area,
            double spacingM,
            List<GeoArea> avoid,
            Optional<GeoArea> within) {
        this(boats, area, spacingM, avoid, within, CrossTrackError.NONE);
    }

    /** An area in open water. */
    public static CoverageProblem of(Map<String, Optional<GeoPoint>> boats, GeoArea area, double spacingM) {
        return new CoverageProblem(boats, area, spacingM, List.of(), Optional.empty());
    }

    /** The same for boats that get so far. */
    public CoverageProblem with(Ranges others) {
        return new CoverageProblem(boats, area, spacingM, avoid, within, error, others, speedsMps, turningRadiiM);
    }

    /** The same for boats of these speeds, in m/s. */
    public CoverageProblem at(Map<String, Double> othersMps) {
        return new CoverageProblem(boats, area, spacingM, avoid, within, error, ranges, othersMps, turningRadiiM);
    }

    /** The same for boats with turning circles of these radii, in metres. */
    public CoverageProblem turningIn(Map<String, Double> radiiM) {
        return new CoverageProblem(boats, area, spacingM, avoid, within, error, ranges, speedsMps, radiiM);
    }

    /** The radius of a boat's narrowest turn, in metres. */
    double turningRadiusM(String boat) {
        return turningRadiiM.getOrDefault(boat, 0.0);
    }

    /** Whether pieces of equal length take all boats equally long: they have one speed and one turning circle. */
    boolean isOfEquals() {
        return boats.keySet().stream().allMatch(boat -> pace(boat) == 1)
                && boats.keySet().stream().map(this::turningRadiusM).distinct().count() == 1;
    }

    /** A boat's speed as a part of the fastest one's: above 0, up to 1. */
    double pace(String boat) {
        double fastestMps = boats.keySet().stream()
                .mapToDouble(one -> speedsMps.getOrDefault(one, 0.0))
                .max()
                .orElse(0);
        return speedsMps.containsKey(boat) ? speedsMps.getOrDefault(boat, fastestMps) / fastestMps : 1;
    }

    /** The same for boats that first leave what is forbidden, where they lie in it, by the shortest way. */
    CoverageProblem outside(Water water) {
        Map<String, Optional<GeoPoint>> others = new LinkedHashMap<>();
        boats.forEach((boat, position) -> others.put(
                boat,
                position.map(at -> water.outside(
                        at, Math.max(LEAST_CLEARANCE_M, water.error().steeringM())))));
        return new CoverageProblem(others, area, spacingM, avoid, within, error, ranges, speedsMps, turningRadiiM);
    }

    /** The same for fewer boats. */
    CoverageProblem withBoats(Collection<String> some) {
        Map<String, Optional<GeoPoint>> others = new LinkedHashMap<>(boats);
        others.keySet().retainAll(some);
        return new CoverageProblem(others, area, spacingM, avoid, within, error, ranges, speedsMps, turningRadiiM);
    }

    /** The same without one boat. */
    CoverageProblem without(String boat) {
        return withBoats(
                boats.keySet().stream().filter(other -> !other.equals(boat)).toList());
    }
}
