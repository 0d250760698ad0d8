package org.sami.dreamm.file;

import java.util.List;
import java.util.Objects;
import java.util.function.Consumer;
import org.sami.dreamm.context.AuthorQuestion;
import org.sami.dreamm.context.DreammContext;
import org.sami.spn.model.Project;

/** Stands before whatever would lose changes: the author is asked first. On the event thread. */
final class UnsavedChanges {
    private static final String ID = "unsaved-changes";

    private final DreammContext context;
    private final Consumer<Runnable> save;

    /**
     * A guard of the document.
     *
     * @param save saves it, and then, if it was saved, goes on with what it is given
     */
    UnsavedChanges(DreammContext context, Consumer<Runnable> save) {
        this.context = Objects.requireNonNull(context, "context");
        this.save = Objects.requireNonNull(save, "save");
    }

    /** Goes on at once where nothing has changed since a project was as it is here; else as {@link #guard}. For what took its time. */
    void guardSince(Project then, Runnable next) {
        if (context.document().project().equals(then)) {
            next.run();
        } else {
            guard(next);
        }
    }

    /** Goes on at once where nothing is unsaved; else when the author has saved, or does not want to. */
    void guard(Runnable next) {
        context.document().giveBack(); // what is shown only is nobody's work
        context.typed().give();
        if (!context.document().isModified()) {
            context.questions().withdraw(ID);
            next.run();
            return;
        }
        String name = context.document()
                .file()
                .map(path -> path.getFileName().toString())
                .orElse("The project, which has no file yet,");
        context.questions()
                .ask(new AuthorQuestion(
                        ID,
                        name + " has changes that are not saved.",
                        List.of(
                                new AuthorQuestion.Choice("unsaved-save", "Save them", () -> save.accept(next)),
                                new AuthorQuestion.Choice("unsaved-drop", "Go on without them", next),
                                new AuthorQuestion.Choice("unsaved-stay", "Stay here", () -> {})),
                        () -> {}));
    }
}
