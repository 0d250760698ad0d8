package org.sami.spn.analysis;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.vocabulary.Geography;

/**
 * The locations of one plan lie together: where one is farther from the others than the domain's robots ever go, it is probably a
 * mistake, most often of latitude and longitude. What robots are launched at counts as the other locations do.
 */
final class FarLocations implements PlanCheck {
    @Override
    public List<Advice> advice() {
        return List.of(
                new Advice(
                        "W-FAR-AWAY",
                        "The robot would drive much farther than missions usually go, perhaps into another water.",
                        "Correct the location; if it is meant so, the warning may stay."),
                new Advice(
                        "W-SWAPPED",
                        "With latitude and longitude exchanged the location lies in another part of the world.",
                        "Exchange latitude and longitude."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        Optional<Geography> geography = plan.vocabulary().geography();
        if (geography.isEmpty()) {
            return;
        }
        GeoValues values = new GeoValues(plan);
        List<GeoPoint> points = new ArrayList<>();
        values.all().forEach(known -> known.points((point, at) -> points.add(point)));
        if (points.size() > 1) {
            List<GeoPoint> locations = new ArrayList<>();
            values.all().forEach(known -> known.locations((point, at) -> locations.add(point)));
            // corners of areas only where there is no more
            GeoPoint middle = middle(locations.size() > 1 ? locations : points);
            double farM = geography.get().farM();
            values.all().forEach(known -> check(known, middle, farM, report));
        }
    }

    /** At most one finding of each kind for a value: the first point stands for the others. */
    private static void check(GeoValues.Known known, GeoPoint middle, double farM, Consumer<Finding> report) {
        List<Spot> swapped = new ArrayList<>();
        List<Spot> far = new ArrayList<>();
        known.points((point, at) -> {
            if (Distances.metres(point, middle) > farM) {
                boolean near = swapped(point)
                        .filter(p -> Distances.metres(p, middle) <= farM)
                        .isPresent();
                (near ? swapped : far).add(new Spot(point, at));
            }
        });
        report(
                swapped,
                known,
                middle,
                "W-SWAPPED",
                ", and would be near them with latitude and longitude swapped: are they swapped?",
                report);
        report(
                far,
                known,
                middle,
                "W-FAR-AWAY",
                ", more than the " + Distances.inWords(farM) + " that are usual: is it right?",
                report);
    }

    private static void report(
            List<Spot> spots,
            GeoValues.Known known,
            GeoPoint middle,
            String code,
            String doubt,
            Consumer<Finding> report) {
        if (!spots.isEmpty()) {
            GeoPoint first = spots.get(0).point;
            String others = spots.size() == 1 ? "" : " (and " + (spots.size() - 1) + " more there)";
            report.accept(Finding.warning(
                    code,
                    spots.get(0).at,
                    "The location " + first.latDeg() + ", " + first.lonDeg() + " in " + known.name() + others + " is "
                            + Distances.inWords(Distances.metres(first, middle))
                            + " from the other locations of the plan" + doubt,
                    known.element()));
        }
    }

    private static Optional<GeoPoint> swapped(GeoPoint p) {
        return Math.abs(p.lonDeg()) > 90
                ? Optional.empty()
                : Optional.of(new GeoPoint(p.lonDeg(), p.latDeg(), p.altM()));
    }

    /** The point that is nearest to the median of latitudes and longitudes: a few wrong ones do not move it. */
    private static GeoPoint middle(List<GeoPoint> points) {
        double[] lats = points.stream().mapToDouble(GeoPoint::latDeg).sorted().toArray();
        double[] lons = points.stream().mapToDouble(GeoPoint::lonDeg).sorted().toArray();
        GeoPoint median = GeoPoint.of(lats[(lats.length - 1) / 2], lons[(lons.length - 1) / 2]);
        GeoPoint nearest = points.get(0);
        for (GeoPoint point : points) {
            if (Distances.metres(point, median) < Distances.metres(nearest, median)) {
                nearest = point;
            }
        }
        return nearest;
    }

    private record Spot(GeoPoint point, String at) {}
}
