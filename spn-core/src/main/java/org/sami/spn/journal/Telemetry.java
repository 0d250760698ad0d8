package org.sami.spn.journal;

import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * The telemetry of a journal, as far as it is true. It changes no state: what is damaged is left out.
 *
 * @param rows in the order in which they were added
 * @param damage which rows are damaged, in words; empty where none is
 */
public record Telemetry(List<TelemetryRow> rows, Optional<String> damage) {
    public Telemetry {
        rows = List.copyOf(rows);
        Objects.requireNonNull(damage, "damage");
    }
}
