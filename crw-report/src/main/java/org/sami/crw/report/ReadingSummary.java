package org.sami.crw.report;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The readings of one channel of all boats together.
 *
 * @param count how many readings
 * @param least the least of all their values
 * @param mean of all their values
 * @param most the greatest of all their values
 */
public record ReadingSummary(
        String sensor, String channel, String unit, int count, double least, double mean, double most) {

    /** The channels in the order in which they were first heard of, without {@linkplain TargetSummary targets}. */
    public static List<ReadingSummary> of(List<ReadingResult> readings) {
        Map<List<String>, List<ReadingResult>> channels = new LinkedHashMap<>();
        for (ReadingResult reading : readings) {
            if (TargetSummary.isTarget(reading)) {
                continue;
            }
            channels.computeIfAbsent(
                            List.of(reading.sensor(), reading.channel(), reading.unit()), key -> new ArrayList<>())
                    .add(reading);
        }
        List<ReadingSummary> summaries = new ArrayList<>();
        channels.forEach((key, of) -> {
            var values = of.stream()
                    .flatMap(reading -> reading.values().stream())
                    .mapToDouble(Double::doubleValue)
                    .summaryStatistics();
            summaries.add(new ReadingSummary(
                    key.get(0),
                    key.get(1),
                    key.get(2),
                    of.size(),
                    values.getMin(),
                    values.getAverage(),
                    values.getMax()));
        });
        return summaries;
    }
}
