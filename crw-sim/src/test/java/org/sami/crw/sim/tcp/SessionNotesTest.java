package org.sami.crw.sim.tcp;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.sim.report.NoteResult;
import org.sami.crw.sim.resume.RunRecord;
import org.sami.crw.sim.run.TestRuns;

/** What a run writes beside the engine's inputs. */
class SessionNotesTest {
    @TempDir
    private Path folder;

    @Test
    void journalThatCannotBeWrittenIsAProblemOfTheRun() throws Exception {
        SessionJournal journal = SessionJournal.create(
                folder.resolve("journal"), new RunRecord(TestRuns.sampleSettings(), "sample", "{}", Map.of()));
        SessionNotes notes = new SessionNotes(journal, () -> 7_000);
        notes.lost("anna");
        assertThat(notes.problem()).isEmpty();

        journal.close();
        notes.lost("anna");

        assertThat(notes.problem()).hasValueSatisfying(problem -> {
            assertThat(problem.isProblem()).isTrue();
            assertThat(problem.kind()).isEqualTo(NoteResult.JOURNAL);
            assertThat(problem.atMillis()).isEqualTo(7_000);
            assertThat(problem.message()).startsWith("telemetry is no longer kept in the journal: ");
        });
    }
}
