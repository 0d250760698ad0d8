package org.sami.crw.log;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * What one channel of a sensor measured over the whole log.
 *
 * @param values how many; those that are no numbers are counted here and nowhere else
 * @param last the latest
 */
public record ChannelSummary(String sensor, String channel, long values, double least, double most, double last) {
    ChannelSummary with(double value) {
        return new ChannelSummary(sensor, channel, values + 1, smaller(least, value), greater(most, value), value);
    }

    private static double smaller(double a, double b) {
        return Double.isNaN(a) || b < a ? b : a;
    }

    private static double greater(double a, double b) {
        return Double.isNaN(a) || b > a ? b : a;
    }

    /** Sums up readings as they come. */
    static final class Collector {
        private final Map<String, Map<String, ChannelSummary>> sensors = new LinkedHashMap<>();

        void add(LogEntry.Reading reading) {
            Map<String, ChannelSummary> channels =
                    sensors.computeIfAbsent(reading.sensor(), sensor -> new LinkedHashMap<>());
            reading.values()
                    .forEach((channel, value) -> channels.merge(
                            channel,
                            new ChannelSummary(reading.sensor(), channel, 1, value, value, value),
                            (before, now) -> before.with(value)));
        }

        List<ChannelSummary> summaries() {
            return sensors.values().stream()
                    .flatMap(channels -> channels.values().stream())
                    .toList();
        }
    }
}
