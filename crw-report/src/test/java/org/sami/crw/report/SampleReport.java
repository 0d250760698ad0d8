package org.sami.crw.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Random;

/** A made-up report in which every kind of row occurs. */
public final class SampleReport {
    private static final LinkResult LINK =
            new LinkResult("in-process", "boot1", 0, 0, new LinkResult.Uploads(3, 3, 2, 1), "it does what it should");

    private static final RunPlace PLACE =
            new RunPlace(new MapPoint(40, -80, 0, 0), Optional.of(new MapPoint(40 - 320 / 111_000.0, -80, 0, -320)));

    private SampleReport() {}

    /** A report with so many boats and locations; always the same. */
    public static RunReport of(int boats, int locations) {
        Random random = new Random(7);
        List<LocationResult> places = new ArrayList<>();
        for (int i = 0; i < locations; i++) {
            double east = random.nextDouble() * 600 - 300;
            double north = random.nextDouble() * 600 - 300;
            boolean visited = i != 2;
            places.add(new LocationResult(
                    i + 1,
                    40 + north / 111_000,
                    -80 + east / 85_000,
                    east,
                    north,
                    visited
                            ? Optional.of(new LocationResult.Visit(60_000L * (i + 1), "boat" + (i % boats + 1)))
                            : Optional.empty()));
        }
        List<BoatResult> fleet = new ArrayList<>();
        for (int b = 0; b < boats; b++) {
            fleet.add(boat(b, boats, places));
        }
        return new RunReport(
                new RunHeader("clv", "Cooperative Location Visit", "cd".repeat(32), "clv", 7, "max", 600, PLACE),
                new RunResult(
                        RunOutcome.ABORTED, "by the user", 754_300, 1.25, 19, 23, OptionalLong.of(12), "ab".repeat(32)),
                fleet,
                places,
                List.of(new DecisionResult(
                        1,
                        1,
                        "OperatorApprove",
                        "Say \"yes\", or no",
                        0,
                        OptionalLong.of(5_000),
                        "operator",
                        "yes",
                        1)),
                List.of(new FiringResult(
                        1, 4, 5_000, 1, "clv", "boats selected", "OperatorSelectsBoatList", "boat1: a, b")),
                List.of(new InterruptResult(
                        "Alarm", "boat1", InterruptResult.TIME, OptionalLong.of(65_000), OptionalLong.of(67_000), 2)),
                List.of(new NoteResult(70_000, "late", 1, "An answer came late.")));
    }

    private static BoatResult boat(int number, int boats, List<LocationResult> places) {
        List<TrackPoint> track = new ArrayList<>();
        double east = (number - boats / 2.0) * 12;
        track.add(new TrackPoint(0, east, -320, 40, -80, 0, 100));
        for (int i = number; i < places.size(); i += boats) {
            LocationResult place = places.get(i);
            track.add(new TrackPoint(
                    60_000L * (i + 1), place.eastM(), place.northM(), place.latDeg(), place.lonDeg(), 1.5, 90.0 - i));
        }
        return new BoatResult("boat" + (number + 1), LINK, 600 * 2.5, 100.0 / 3, 0, number, track);
    }
}
