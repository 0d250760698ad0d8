package org.sami.crw.sim.run.record;

import java.util.function.Consumer;
import org.sami.crw.session.SessionListener;
import org.sami.crw.session.archive.SessionNote;
import org.sami.crw.sim.run.RunNews;

/** Passes the messages to the operator to the run's report, and shows those about boats and links at once. Safe for several threads. */
public final class RunNotes implements SessionListener {
    private final NoteFold fold = new NoteFold();
    private final Consumer<String> shown;
    private volatile boolean messagesAreNews;

    /** Notes of which those are shown that must be. */
    public RunNotes(Consumer<String> shown) {
        this.shown = shown;
    }

    @Override
    public void onNote(SessionNote note) {
        fold.onNote(note);
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

    /** The report's part that keeps them, also those of earlier processes. */
    public NoteFold fold() {
        return fold;
    }
}
