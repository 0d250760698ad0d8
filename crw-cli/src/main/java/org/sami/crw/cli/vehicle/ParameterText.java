package org.sami.crw.cli.vehicle;

import java.nio.file.Path;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import org.sami.mavlink.param.KeptParameters;
import org.sami.mavlink.vehicle.VehicleId;

/** Parameters that were read, as lines for people. */
final class ParameterText {
    private static final int MOST_LINES = 50;
    private static final DateTimeFormatter MINUTE = DateTimeFormatter.ofPattern("yyyy-MM-dd HH:mm");

    private ParameterText() {}

    /**
     * How many there are, and what has changed since they were kept last.
     *
     * @param before what was kept of the vehicle before, empty where nothing was
     * @param zone in which times are told
     */
    static String of(
            VehicleId vehicle,
            SortedMap<String, Double> values,
            Optional<KeptParameters> before,
            Path folder,
            ZoneId zone) {
        StringBuilder text =
                new StringBuilder(String.format("%s has %d parameters, kept in %s%n", vehicle, values.size(), folder));
        before.ifPresent(kept -> {
            String since = MINUTE.format(kept.since().atZone(zone));
            List<String> changes = kept.changes(values);
            text.append(String.format(
                    changes.isEmpty() ? "%s: none has changed since %s%n" : "%s: changed since %s:%n", vehicle, since));
            changes.stream().limit(MOST_LINES).forEach(line -> text.append(String.format("  %s%n", line)));
            if (changes.size() > MOST_LINES) {
                text.append(String.format("  and %d more%n", changes.size() - MOST_LINES));
            }
        });
        return text.toString();
    }
}
