package org.sami.dreamm.context;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/** What the author is asked, the oldest first; nothing waits for an answer. On the event thread. */
public final class Questions {
    private final List<AuthorQuestion> open = new ArrayList<>();
    private final List<AuthorQuestion> aside = new ArrayList<>();
    private final List<Runnable> listeners = new ArrayList<>();

    /** Asks what a command of the author's has to know: the question takes the focus. */
    public void ask(AuthorQuestion question) {
        put(question);
    }

    /** Asks because of something that the author has not done: what he types goes on where he types it. */
    public void askAside(AuthorQuestion question) {
        aside.add(question);
        put(question);
    }

    /** Whether a question takes the focus. */
    public boolean takesFocus(AuthorQuestion question) {
        return !aside.contains(question);
    }

    private void put(AuthorQuestion question) {
        int before = indexOf(question.id());
        if (before >= 0) {
            open.set(before, question);
        } else {
            open.add(question);
        }
        tell();
    }

    /** The question that is asked now. */
    public Optional<AuthorQuestion> current() {
        return open.stream().findFirst();
    }

    /** How many more wait behind it. */
    public int waiting() {
        return Math.max(0, open.size() - 1);
    }

    /** The author has chosen. */
    public void answer(AuthorQuestion question, AuthorQuestion.Choice choice) {
        if (open.remove(question)) {
            tell();
            choice.chosen().run();
        }
    }

    /** The author leaves a question. */
    public void dismiss(AuthorQuestion question) {
        if (open.remove(question)) {
            tell();
            question.dismissed().run();
        }
    }

    /** Takes a question back that has no ground any longer. */
    public void withdraw(String id) {
        if (open.removeIf(question -> question.id().equals(id))) {
            tell();
        }
    }

    private int indexOf(String id) {
        for (int i = 0; i < open.size(); i++) {
            if (open.get(i).id().equals(id)) {
                return i;
            }
        }
        return -1;
    }

    private void tell() {
        aside.retainAll(open);
        List.copyOf(listeners).forEach(Runnable::run);
    }

    /** Calls a listener when another question, or none, is asked. */
    public void addListener(Runnable listener) {
        listeners.add(Objects.requireNonNull(listener, "listener"));
    }
}
