package org.sami.crw.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** What the things on a run's map are called, in its legend and in the files that other programs draw. */
public final class MapNames {
    private MapNames() {}

    /** The plan, its seed and how the run ended. */
    public static String run(RunReport report) {
        return String.format(
                Locale.ROOT,
                "plan %s, seed %d, %s after %s",
                report.header().plan(),
                report.header().seed(),
                report.result().outcome().word(),
                ReportWords.duration(report.result().simulatedMillis()));
    }

    /** Which boat visited a location and when, and by how much it truly missed it. */
    public static String of(LocationResult location) {
        if (location.visited()) {
            return "visited by " + words(location.visit().orElseThrow());
        }
        String missed = location.truth()
                .flatMap(truth -> truth.nearestM().stream()
                        .mapToObj(nearest -> String.format(Locale.ROOT, ", truly missed by %.1f m", nearest))
                        .findFirst())
                .orElse(", truly missed");
        return location.reported()
                .map(visit -> "reported visited by " + words(visit) + missed)
                .orElse("not visited");
    }

    private static String words(LocationResult.Visit visit) {
        return String.format(Locale.ROOT, "%s at %.1f s", visit.boat(), visit.atMillis() / 1000.0);
    }

    /** What a spot is, and of which boat. */
    public static String of(MapSpot spot) {
        return spot.kind().words() + (spot.boat().isEmpty() ? "" : " of " + spot.boat());
    }

    /** How far a boat drove, and what charge it had at the end. */
    public static String of(BoatResult boat) {
        return String.format(Locale.ROOT, "%.0f m, battery %.0f %%", boat.distanceM(), boat.batteryPercent());
    }

    /** Where a location is. */
    public static MapPoint point(LocationResult location) {
        return new MapPoint(location.latDeg(), location.lonDeg(), location.eastM(), location.northM());
    }

    /** The areas of the plan, and then what was left uncovered. */
    public static List<MapArea> areas(RunReport report) {
        List<MapArea> areas = new ArrayList<>(report.map().areas());
        report.map().explorations().forEach(exploration -> areas.addAll(exploration.uncovered()));
        return areas;
    }
}
