package org.sami.ui.window;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;

/** One line at a time for the operator: what a command did, or why it was refused. On the event thread. */
public final class Notices {
    private final List<Consumer<Notice>> listeners = new ArrayList<>();
    private final UnaryOperator<String> words;

    /** Notices as they are given. */
    public Notices() {
        this(UnaryOperator.identity());
    }

    /** Notices in a domain's words. */
    public Notices(UnaryOperator<String> words) {
        this.words = words;
    }

    /**
     * A line.
     *
     * @param refused whether it says why something was not done
     */
    public record Notice(String text, boolean refused) {}

    /** Shows what was done. */
    public void show(String text) {
        tell(new Notice(words.apply(text), false));
    }

    /** Shows why something was not done. */
    public void refused(String text) {
        tell(new Notice(words.apply(text), true));
    }

    private void tell(Notice notice) {
        listeners.forEach(listener -> listener.accept(notice));
    }

    /** Adds a listener that shows them. */
    public void addListener(Consumer<Notice> listener) {
        listeners.add(listener);
    }
}
