package org.sami.crw.decision;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import org.sami.crw.service.Geodesy;
import org.sami.spn.value.BooleanValue;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;

/**
 * Values that the simulated operator makes up, from a seed and nothing else. The first list of locations is the same for every
 * plan with the same seed, so that plans can be compared; each later one differs.
 */
final class GeneratedValues {
    /** A single point lies in the inner part of the square, so that boats that gather there stay inside. */
    private static final double INNER_PART = 0.5;

    private final DefaultAnswers defaults;
    private final Random locations;
    private final Random points;

    GeneratedValues(DefaultAnswers defaults) {
        this.defaults = defaults;
        locations = new Random(mixed(defaults.seed()));
        points = new Random(mixed(defaults.seed() ^ 0x5A5A5A5AL));
    }

    /** A value of a type; empty for types of which nothing sensible can be made up. */
    Optional<Value> of(ValueType type) {
        if (type.equals(ValueType.Simple.POINT)) {
            return Optional.of(pointIn(points, defaults.areaM() * INNER_PART));
        }
        if (type.equals(ValueType.Simple.PATH)) {
            return Optional.of(new GeoPath(markLocations()));
        }
        if (type.equals(ValueType.Simple.AREA)) {
            return Optional.of(square());
        }
        if (type.equals(ValueType.Simple.BOOLEAN)) {
            return Optional.of(new BooleanValue(true));
        }
        if (type.equals(ValueType.Simple.PROXY)) {
            return lastBoat();
        }
        if (type instanceof ValueType.ListOf list && list.element().equals(ValueType.Simple.POINT)) {
            return Optional.of(new ListValue(List.copyOf(markLocations())));
        }
        if (type instanceof ValueType.MapOf map && map.key().equals(ValueType.Simple.PROXY)) {
            return forEachBoat(map.value());
        }
        return Optional.empty();
    }

    /** The last one, as fewer boats than there are begin with the first. */
    private Optional<Value> lastBoat() {
        List<String> boats = defaults.boats();
        return boats.isEmpty() ? Optional.empty() : Optional.of(new ProxyValue(boats.get(boats.size() - 1)));
    }

    private Optional<Value> forEachBoat(ValueType share) {
        Map<Value, Value> shares = new LinkedHashMap<>();
        for (String boat : defaults.boats()) {
            of(share).ifPresent(value -> shares.put(new ProxyValue(boat), value));
        }
        return shares.isEmpty() ? Optional.empty() : Optional.of(new MapValue(shares));
    }

    private List<GeoPoint> markLocations() {
        List<GeoPoint> marked = new ArrayList<>();
        for (int i = 0; i < defaults.locations(); i++) {
            marked.add(pointIn(locations, defaults.areaM()));
        }
        return marked;
    }

    private GeoPoint pointIn(Random random, double sideM) {
        double eastM = (random.nextDouble() - 0.5) * sideM;
        double northM = (random.nextDouble() - 0.5) * sideM;
        return rounded(Geodesy.offset(defaults.centre(), eastM, northM));
    }

    private GeoArea square() {
        double half = defaults.areaM() / 2;
        List<GeoPoint> corners = new ArrayList<>();
        for (double[] corner : new double[][] {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
            corners.add(rounded(Geodesy.offset(defaults.centre(), corner[0] * half, corner[1] * half)));
        }
        return new GeoArea(corners, List.of());
    }

    /** To the centimetre, as an operator's map would give it and a file can show it. */
    private static GeoPoint rounded(GeoPoint point) {
        return GeoPoint.of(Math.rint(point.latDeg() * 1e7) / 1e7, Math.rint(point.lonDeg() * 1e7) / 1e7);
    }

    /** Spreads neighbouring seeds: the first numbers of {@link Random} hardly differ for them. */
    private static long mixed(long seed) {
        long z = seed + 0x9E3779B97F4A7C15L;
        z = (z ^ (z >>> 30)) * 0xBF58476D1CE4E5B9L;
        z = (z ^ (z >>> 27)) * 0x94D049BB133111EBL;
        return z ^ (z >>> 31);
    }
}
