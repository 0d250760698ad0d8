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

    /** Something was done. */
    public void told(String text) {
        tell(new Notice(text, false));
    }

    /** Something was not done, for this reason. */
    public void refused(String text) {
        tell(new Notice(text, true));
    }

    private void tell(Notice notice) {
        listeners.forEach(listener -> listener.accept(notice));
    }

    /** Adds who shows them. */
    public void addListener(Consumer<Notice> listener) {
        listeners.add(listener);
    }
}
