package org.sami.crw.service.reach;

import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.IntStream;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.path.Detour;
import org.sami.crw.service.water.Water;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/** Checks a way before a boat drives it, and returns the first problem; a pure function. */
public final class WayCheck {
    /** A point farther from the boat than this, in metres, is nowhere that a boat of the fleet comes back from. */
    public static final double FAR_M = 5_000;

    /** A point nearer to the robot than this, in metres, is where it is. */
    private static final double HERE_M = 0.5;

    private WayCheck() {}

    /** What is wrong; empty where nothing is, or where the boat's position is not known. */
    public static Optional<WayDoubt> doubt(Way way) {
        if (way.points().isEmpty() || way.from().isEmpty()) {
            return Optional.empty();
        }
        GeoPoint from = way.from().get();
        return far(way, from)
                .or(() -> onLand(way, from))
                .or(() -> noWayAround(way, from))
                .or(() -> beyondCharge(way, from));
    }

    private static Optional<WayDoubt> far(Way way, GeoPoint from) {
        GeoPoint farthest = way.points().stream()
                .max(Comparator.comparingDouble(point -> Geodesy.distanceM(from, point)))
                .orElseThrow();
        double distanceM = Geodesy.distanceM(from, farthest);
        if (distanceM <= FAR_M) {
            return Optional.empty();
        }
        String words =
                way.boat() + " is to go " + kilometres(distanceM) + " from where it is, to " + WayDanger.text(farthest);
        return Optional.of(new WayDoubt(WayDoubt.Kind.PLACE, words + exchanged(from, farthest)));
    }

    /** Who gives longitude before latitude means a place that is near. */
    private static String exchanged(GeoPoint from, GeoPoint point) {
        if (Math.abs(point.lonDeg()) > 90) {
            return "";
        }
        GeoPoint other = GeoPoint.of(point.lonDeg(), point.latDeg());
        return Geodesy.distanceM(from, other) <= FAR_M
                ? "; are latitude and longitude exchanged? " + WayDanger.text(other) + " is near"
                : "";
    }

    private static Optional<WayDoubt> onLand(Way way, GeoPoint from) {
        int first = firstElsewhere(way.points(), from);
        for (GeoArea area : way.avoid()) {
            for (int i = first; i < way.points().size(); i++) {
                GeoPoint point = way.points().get(i);
                Water around = Water.of(point, List.of(area), Optional.empty());
                if (around.clearanceM(point) == 0) {
                    return Optional.of(new WayDoubt(
                            WayDoubt.Kind.PLACE,
                            way.boat() + " is to go to " + WayDanger.text(point) + ", point " + (i + 1)
                                    + String.format(
                                            Locale.ROOT,
                                            " of its way, which lies %.1f m inside a no-go area",
                                            around.depthM(point))));
                }
            }
        }
        return Optional.empty();
    }

    /** The first point at which a way leaves where the robot is, as an aircraft does that climbs before it goes; 0 where it goes nowhere else. */
    private static int firstElsewhere(List<GeoPoint> points, GeoPoint from) {
        return IntStream.range(0, points.size())
                .filter(i -> Geodesy.distanceM(from, points.get(i)) > HERE_M)
                .findFirst()
                .orElse(0);
    }

    /** A leg that leads through what is to be avoided, and around it there is no way; a boat that is in it may leave it. */
    private static Optional<WayDoubt> noWayAround(Way way, GeoPoint from) {
        GeoPoint at = from;
        for (GeoPoint point : way.points()) {
            GeoPoint start = at;
            boolean isBarred = way.water()
                    .filter(water -> water.clearanceM(start) > 0 && water.clearanceM(List.of(start, point)) == 0)
                    .filter(water -> Detour.between(start, point, water).isEmpty())
                    .isPresent();
            if (isBarred) {
                return Optional.of(new WayDoubt(
                        WayDoubt.Kind.PLACE,
                        way.boat() + " is to go to " + WayDanger.text(point)
                                + " through a no-go area, and there is no way around"));
            }
            at = point;
        }
        return Optional.empty();
    }

    private static Optional<WayDoubt> beyondCharge(Way way, GeoPoint from) {
        if (way.charge().isEmpty()) {
            return Optional.empty();
        }
        double lengthM = Geodesy.lengthM(from, Detour.along(from, way.points(), way.water()));
        double percent = way.charge().get().percent();
        double rangeM = way.charge().get().sureM();
        return lengthM <= rangeM
                ? Optional.empty()
                : Optional.of(new WayDoubt(
                        WayDoubt.Kind.CHARGE,
                        String.format(
                                Locale.ROOT,
                                "%s is to go %s, and its charge of %.0f %% is sure to last for %s, %s less",
                                way.boat(),
                                kilometres(lengthM),
                                percent,
                                kilometres(rangeM),
                                kilometres(lengthM - rangeM))));
    }

    private static String kilometres(double metres) {
        if (metres < 950) {
            return String.format(Locale.ROOT, "%.0f m", metres);
        }
        return String.format(Locale.ROOT, metres < 9_950 ? "%.1f km" : "%.0f km", metres / 1000);
    }
}
