package org.sami.spn.journal;

import java.util.Objects;

/**
 * One row of telemetry: it changes no state and carries no checksum of its own.
 *
 * @param atMillis the session's time
 * @param kind what was read, such as "pose"
 * @param json the reading
 */
public record TelemetryRow(long atMillis, String proxy, String kind, String json) {
    public TelemetryRow {
        Objects.requireNonNull(proxy, "proxy");
        Objects.requireNonNull(kind, "kind");
        Objects.requireNonNull(json, "json");
    }
}
