package org.sami.crw.service.reach;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.regex.Pattern;
import org.sami.crw.service.path.Detour;
import org.sami.crw.service.water.CrossTrackError;
import org.sami.crw.service.water.Water;
import org.sami.spn.value.GeoPoint;

/** Says of a way, before it is driven, how far a boat may come into what is to be avoided. Pure functions. */
public final class WayDanger {
    private static final Pattern DEPTH = Pattern.compile("(\\d+\\.\\d) m inside");

    private WayDanger() {}

    /** How deep a boat comes inside at most by words of {@link #of}, in metres to a tenth; empty where they say nothing of it. */
    public static OptionalDouble announcedM(String words) {
        return DEPTH.matcher(words)
                .results()
                .mapToDouble(found -> Double.parseDouble(found.group(1)))
                .max();
    }

    /**
     * Clauses for the operator, each without the boat's name: where the way begins or leads inside, and where it passes too near. None for a way
     * on which no boat comes inside.
     *
     * @param from where the boat is
     * @param points in driving order; legs turn around what is to be avoided where there is a way around
     */
    public static List<String> of(GeoPoint from, List<GeoPoint> points, Water water) {
        List<String> words = new ArrayList<>();
        CrossTrackError error = water.error();
        double startM = water.depthM(from);
        if (startM > 0) {
            words.add(String.format(
                    Locale.ROOT,
                    "lies %.1f m inside what is to be avoided, and leaves it on the shortest way",
                    startM));
        }
        Optional<GeoPoint> deepest = points.stream()
                .filter(point -> water.depthM(point) > 0)
                .max((one, other) -> Double.compare(water.depthM(one), water.depthM(other)));
        deepest.ifPresent(point -> words.add(inside(point, water)));
        double leastM = Double.POSITIVE_INFINITY;
        List<GeoPoint> nearest = List.of();
        for (List<GeoPoint> leg : clearLegs(from, points, water)) {
            double clearanceM = water.clearanceM(leg);
            if (clearanceM < leastM) {
                leastM = clearanceM;
                nearest = leg;
            }
        }
        if (error.insideM(leastM) > 0) {
            words.add(String.format(
                    Locale.ROOT,
                    "passes what is to be avoided at %.1f m near %s; boats may be %.1f m beside their way, so up to %.1f m inside",
                    leastM,
                    text(water.nearest(nearest)),
                    error.mostM(),
                    error.insideM(leastM)));
        }
        return words;
    }

    private static String inside(GeoPoint point, Water water) {
        return String.format(
                Locale.ROOT,
                "is sent to %s, which lies %.1f m inside what is to be avoided; boats may be %.1f m beside their way, so up to %.1f m inside",
                text(point),
                water.depthM(point),
                water.error().mostM(),
                water.depthM(point) + water.error().mostM());
    }

    /** The legs as they are driven, but for those that begin or end inside, and those that have no way around. */
    private static List<List<GeoPoint>> clearLegs(GeoPoint from, List<GeoPoint> points, Water water) {
        List<List<GeoPoint>> legs = new ArrayList<>();
        GeoPoint at = from;
        for (GeoPoint point : points) {
            List<GeoPoint> leg = new ArrayList<>(List.of(at));
            Detour.between(at, point, water).ifPresent(leg::addAll);
            leg.add(point);
            if (water.allows(leg)) {
                legs.add(leg);
            }
            at = point;
        }
        return legs;
    }

    static String text(GeoPoint point) {
        return String.format(Locale.ROOT, "%.5f,%.5f", point.latDeg(), point.lonDeg());
    }
}
