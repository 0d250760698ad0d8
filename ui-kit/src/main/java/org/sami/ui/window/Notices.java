package org.sami.ui.window;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/** One line at a time for the operator: what a command did, or why it was refused. On the event thread. */
public final class Notices {
    private final List<Consumer<Notice>> listeners = new ArrayList<>();

    /**
     * A line.
     *
     * @param refused whether it says why something was not done
     */
    public record Notice(String text, boolean refused) {}

    /** Shows what was done. */
    public void show(String text) {
        tell(new Notice(text, false));
    }

    /** Shows why something was not done. */
    public void refused(String text) {
        tell(new Notice(text, true));
    }

    private void tell(Notice notice) {
        listeners.forEach(listener -> listener.accept(notice));
    }

    /** Adds a listener that shows them. */
    public void addListener(Consumer<Notice> listener) {
        listeners.add(listener);
    }
}
