package org.sami.crw.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/**
 * One target that the detectors of robots reported, of all robots together.
 *
 * @param number names it
 * @param latDeg WGS 84 latitude in degrees, as it was reported last
 * @param lonDeg WGS 84 longitude in degrees, as it was reported last
 * @param count how often it was reported
 * @param firstAtMillis when the base first heard of it, from the start of the run, in milliseconds
 * @param boats those that reported it, in the order in which they first did
 */
public record TargetSummary(
        int number, double latDeg, double lonDeg, int count, long firstAtMillis, List<String> boats) {
    /** The channel of detectors. Its readings have three values: the target's number, latitude and longitude. */
    private static final String CHANNEL = "target";

    private static final int VALUES = 3;

    public TargetSummary {
        boats = List.copyOf(boats);
    }

    /** Whether a reading names a target with its place, so that its values are no measurements. */
    static boolean isTarget(ReadingResult reading) {
        return reading.channel().equals(CHANNEL)
                && reading.values().size() == VALUES
                && Math.abs(reading.values().get(1)) <= 90
                && Math.abs(reading.values().get(2)) <= 180;
    }

    /** The targets among readings, by number. */
    public static List<TargetSummary> of(List<ReadingResult> readings) {
        Map<Integer, TargetSummary> targets = new TreeMap<>();
        readings.stream().filter(TargetSummary::isTarget).forEach(reading -> {
            int number = (int) Math.round(reading.values().get(0));
            targets.put(number, next(number, Optional.ofNullable(targets.get(number)), reading));
        });
        return List.copyOf(targets.values());
    }

    private static TargetSummary next(int number, Optional<TargetSummary> before, ReadingResult reading) {
        List<String> boats = new ArrayList<>(before.map(TargetSummary::boats).orElse(List.of()));
        if (!boats.contains(reading.boat())) {
            boats.add(reading.boat());
        }
        return new TargetSummary(
                number,
                reading.values().get(1),
                reading.values().get(2),
                before.map(TargetSummary::count).orElse(0) + 1,
                before.map(TargetSummary::firstAtMillis).orElse(reading.atMillis()),
                boats);
    }
}
