package org.sami.spn.journal;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.spn.host.Durability;
import org.sami.spn.host.JournalEntry;
import org.sami.spn.protocol.Input;

class JournalTablesTest {
    @TempDir
    Path folder;

    /** Of somebody who writes nothing. */
    private static final class NoRows implements RowWriter {
        @Override
        public void entries(List<EntryRow> rows) {
            throw new UnsupportedOperationException();
        }

        @Override
        public void telemetry(List<SummedTelemetry> rows) {
            throw new UnsupportedOperationException();
        }
    }

    @Test
    void stateAndTelemetryThatWereKnownBeforeAreGivenAwayOnceAndNotKept() throws Exception {
        Path file = folder.resolve("session.journal");
        try (SqliteJournal journal = SqliteJournal.create(
                        file, JournalHeader.of("plans", Map.of(), Map.of()), JournalOptions.DEFAULT);
                Connection connection = DriverManager.getConnection("jdbc:sqlite:" + file)) {
            journal.append(List.of(new JournalEntry(1, 100, new Input.ProxyJoined("b"))), Durability.PROCESS);
            JournalPart known = new JournalPart(
                    Scan.of("it", connection),
                    Optional.of(new JournalPart.KeptState(1, new byte[] {1})),
                    new JournalPart.KeptTelemetry(
                            List.of(new TelemetryRow(100, "b", "pose", "{}")), 1, Optional.empty()));
            JournalTables tables =
                    JournalTables.open("it", connection, new NoRows(), Optional.of(known), JournalOptions.DEFAULT);

            JournalPart taken = tables.takeRead();
            JournalPart left = tables.takeRead();

            assertThat(taken.stateAt()).hasValue(1L);
            assertThat(taken.telemetry().rows()).hasSize(1);
            assertThat(left.stateAt()).isEmpty();
            assertThat(left.telemetry().rows()).isEmpty();
            assertThat(left.lastIndex()).isEqualTo(1);
        }
    }
}
