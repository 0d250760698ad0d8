package org.sami.crw.service.reach;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.sami.crw.service.path.Detour;
import org.sami.crw.service.water.CrossTrackError;
import org.sami.crw.service.water.Water;
import org.sami.spn.value.GeoPoint;

/**
 * A warning that a boat may enter an area to avoid on a way, given before it drives it. Immutable.
 *
 * @param words a clause for the operator, without the boat's name
 * @param insideM largest depth inside, in metres, rounded to a tenth as in the words
 */
public record WayDanger(String words, double insideM) {
    /**
     * The dangers of a way: where it begins or leads inside, and where it passes too near. None for a way on which no boat comes inside.
     *
     * @param from where the boat is
     * @param points in driving order; legs turn around no-go areas where there is a way around
     */
    public static List<WayDanger> of(GeoPoint from, List<GeoPoint> points, Water water) {
        List<WayDanger> dangers = new ArrayList<>();
        CrossTrackError error = water.error();
        double startM = water.depthM(from);
        if (startM > 0) {
            dangers.add(danger(startM, "lies %.1f m inside a no-go area, and leaves it on the shortest way", startM));
        }
        Optional<GeoPoint> deepest = points.stream()
                .filter(point -> water.depthM(point) > 0)
                .max((one, other) -> Double.compare(water.depthM(one), water.depthM(other)));
        deepest.ifPresent(point -> dangers.add(inside(point, water)));
        double leastM = Double.POSITIVE_INFINITY;
        List<GeoPoint> nearest = List.of();
        for (List<GeoPoint> leg : clearLegs(from, points, water)) {
            double clearanceM = water.clearanceM(leg);
            if (clearanceM < leastM) {
                leastM = clearanceM;
                nearest = leg;
            }
        }
        if (water.margin().insideM(leastM) > 0) {
            dangers.add(danger(
                    water.margin().insideM(leastM),
                    "passes a no-go area at %.1f m near %s; boats may be %.1f m off their path, so up to %.1f m inside",
                    leastM,
                    text(water.nearest(nearest)),
                    error.mostM(),
                    water.margin().insideM(leastM)));
        }
        return dangers;
    }

    private static WayDanger inside(GeoPoint point, Water water) {
        return danger(
                water.depthM(point) + water.error().mostM(),
                "is sent to %s, which lies %.1f m inside a no-go area; boats may be %.1f m off their path, so up to %.1f m inside",
                text(point),
                water.depthM(point),
                water.error().mostM(),
                water.depthM(point) + water.error().mostM());
    }

    private static WayDanger danger(double insideM, String format, Object... parts) {
        return new WayDanger(String.format(Locale.ROOT, format, parts), Math.round(insideM * 10) / 10.0);
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
