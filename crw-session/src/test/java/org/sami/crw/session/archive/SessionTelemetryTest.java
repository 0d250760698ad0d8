package org.sami.crw.session.archive;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.session.record.SessionNote;
import org.sami.session.record.SessionTelemetry;
import org.sami.spn.journal.JournalHeader;

/** What a session writes next to the engine's inputs. */
class SessionTelemetryTest {
    @TempDir
    private Path folder;

    @Test
    void journalThatCannotBeWrittenIsAProblemThatIsTold() throws Exception {
        SessionJournal journal =
                SessionJournal.create(folder.resolve("journal"), JournalHeader.of("{}", Map.of(), Map.of()));
        SessionTelemetry telemetry = new SessionTelemetry(journal::addTelemetry, () -> 7_000);
        telemetry.lost("anna");
        assertThat(telemetry.problem()).isEmpty();

        journal.close();
        telemetry.lost("anna");

        assertThat(telemetry.problem()).hasValueSatisfying(problem -> {
            assertThat(problem.kind()).isEqualTo(SessionNote.JOURNAL);
            assertThat(problem.atMillis()).isEqualTo(7_000);
            assertThat(problem.text()).startsWith("telemetry is no longer kept in the journal: ");
        });
    }
}
