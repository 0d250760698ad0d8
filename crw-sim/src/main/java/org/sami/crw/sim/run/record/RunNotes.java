package org.sami.crw.sim.run.record;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.sami.crw.session.SessionListener;
import org.sami.crw.session.SessionNote;
import org.sami.crw.sim.report.NoteResult;
import org.sami.crw.sim.run.RunNews;

/** Keeps what the operator is told in a run, for its report, and shows at once what is said of boats and links. Safe for several threads. */
public final class RunNotes implements SessionListener {
    private final List<NoteResult> told = new ArrayList<>();
    private final Consumer<String> shown;
    private volatile boolean messagesAreNews;

    /** Notes of which those are shown that must be. */
    public RunNotes(Consumer<String> shown) {
        this.shown = shown;
    }

    @Override
    public void onNote(SessionNote note) {
        keep(note);
        if (note.isUrgent() && !(messagesAreNews && note.isMessage())) {
            shown.accept(note.text());
        }
    }

    /** From now on messages to the operator are shown by {@link RunNews}, and not here as well; or here again. */
    public void leaveMessagesToNews(boolean leave) {
        messagesAreNews = leave;
    }

    @Override
    public void onNotice(String text) {
        shown.accept(text);
    }

    /** Keeps a note, also one of an earlier process. */
    public synchronized void keep(SessionNote note) {
        told.add(new NoteResult(note.atMillis(), note.kind(), note.mission(), note.text()));
    }

    /** Everything so far, in the order in which it was told. */
    public synchronized List<NoteResult> all() {
        return List.copyOf(told);
    }
}
