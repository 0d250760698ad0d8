package org.sami.spn.journal;

import java.sql.SQLException;
import java.util.List;

/** Writes rows of a journal's tables in the way that is quick on its database; the caller commits. */
public interface RowWriter {
    /** Adds entries, in order. */
    void entries(List<EntryRow> rows) throws SQLException;

    /** Adds telemetry, in order. */
    void telemetry(List<SummedTelemetry> rows) throws SQLException;

    /**
     * An entry as it stands in its table.
     *
     * @param input one line of JSON
     * @param checksum of the chain (docs/decisions 0031)
     */
    record EntryRow(long index, long atMillis, String input, Checksum checksum) {}

    /**
     * A row of telemetry with its checksum.
     *
     * @param sum CRC-32C
     */
    record SummedTelemetry(TelemetryRow row, long sum) {}
}
