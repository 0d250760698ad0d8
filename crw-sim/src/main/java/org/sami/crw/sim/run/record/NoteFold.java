package org.sami.crw.sim.run.record;

import java.util.ArrayList;
import java.util.List;
import org.sami.crw.report.NoteResult;
import org.sami.session.record.SessionNote;

/** The messages to the operator. Safe for use by several threads. */
public final class NoteFold implements ReportFold {
    private final List<NoteResult> recorded = new ArrayList<>();

    @Override
    public synchronized void onNote(SessionNote note) {
        recorded.add(new NoteResult(note.atMillis(), note.kind(), note.mission(), note.text()));
    }

    @Override
    public synchronized void addTo(ReportDraft report) {
        report.note(recorded);
    }
}
