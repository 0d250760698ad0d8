package org.sami.crw.sim.run.record;

import java.util.function.Consumer;
import org.sami.crw.session.SessionListener;
import org.sami.crw.sim.run.RunNews;
import org.sami.session.record.SessionNote;

/** Passes messages to the operator on to the run's report, and shows those about boats and links at once. Safe for several threads. */
public final class RunNotes implements SessionListener {
    private final NoteFold fold = new NoteFold();
    private final Consumer<String> shown;
    private volatile boolean messagesAreNews;

    /** Notes; urgent ones are shown. */
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

    /** Sets whether {@link RunNews} shows messages to the operator instead of this class. */
    public void leaveMessagesToNews(boolean leave) {
        messagesAreNews = leave;
    }

    @Override
    public void onNotice(String text) {
        shown.accept(text);
    }

    /** The fold that keeps the messages, also those of earlier processes. */
    public NoteFold fold() {
        return fold;
    }
}
