package org.sami.dreamm.document;

import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import org.sami.dreamm.document.DocumentChange.Cause;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.EditHistory;
import org.sami.spn.edit.EditResult;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * The project that a window shows, with its history and its file. One for as long as the window is open: another project that is opened takes
 * the place of the one before. On the event thread.
 */
public final class ProjectDocument {
    private static final int MOST_UNDO = 1000;

    private final Vocabulary vocabulary;
    private final List<DocumentListener> listeners = new CopyOnWriteArrayList<>();
    private EditHistory history;
    private Optional<Path> file;
    private Optional<Own> own = Optional.empty();

    /** The author's project with its history, put aside while another one is shown. */
    private record Own(EditHistory history, Optional<Path> file) {}

    /**
     * What the author works on.
     *
     * @param file that it is saved to
     * @param modified whether it has changes that are not in its file
     */
    public record Work(Project project, Optional<Path> file, boolean modified) {}

    /**
     * A document that counts as saved.
     *
     * @param file where it came from, and is saved to: a file or a folder; empty where it came from none
     */
    public ProjectDocument(Vocabulary vocabulary, Project opened, Optional<Path> file) {
        this.vocabulary = Objects.requireNonNull(vocabulary, "vocabulary");
        this.history = new EditHistory(opened, vocabulary, MOST_UNDO);
        this.file = Objects.requireNonNull(file, "file");
    }

    /** The project as it is now. */
    public Project project() {
        return history.project();
    }

    /** A plan as it is now; empty where the project has none of that id. */
    public Optional<Plan> plan(String id) {
        return project().plan(id);
    }

    /** The words of the domain. */
    public Vocabulary vocabulary() {
        return vocabulary;
    }

    /** The file or folder that it is saved to; empty where it has none yet. */
    public Optional<Path> file() {
        return file;
    }

    /** Whether it has changes that are not in its file. */
    public boolean isModified() {
        return history.isModified();
    }

    /** Makes an edit. One that is refused, or changes nothing, reaches no listener; the caller shows the reason to the author. */
    public EditResult apply(Edit edit) {
        Project before = project();
        EditResult result = history.apply(edit);
        if (result instanceof EditResult.Done done && !before.equals(project())) {
            tell(Cause.EDITED, before, done);
        }
        return result;
    }

    /** Takes the last edit back; empty where there is none. */
    public Optional<EditResult.Done> undo() {
        Project before = project();
        Optional<EditResult.Done> done = history.undo();
        done.ifPresent(d -> tell(Cause.UNDONE, before, d));
        return done;
    }

    /** Makes the edit again that was taken back last; empty where there is none. */
    public Optional<EditResult.Done> redo() {
        Project before = project();
        Optional<EditResult.Done> done = history.redo();
        done.ifPresent(d -> tell(Cause.REDONE, before, d));
        return done;
    }

    /** What undo would take back, in words; empty where there is nothing. */
    public Optional<String> undoLabel() {
        return history.undoLabel();
    }

    /** What redo would make again, in words; empty where there is nothing. */
    public Optional<String> redoLabel() {
        return history.redoLabel();
    }

    /** Puts another project into the place of the one that was, which is forgotten with its history. It counts as saved. */
    public void open(Project opened, Optional<Path> from) {
        own = Optional.empty();
        show(new EditHistory(opened, vocabulary, MOST_UNDO), from);
    }

    /**
     * Shows another project until {@link #giveBack}, such as a copy on which something is explained. The author's own project, its history and its
     * file stay as they are; the one that is shown has no file. One that is shown already is shown no longer.
     */
    public void lend(Project copy) {
        if (own.isEmpty()) {
            own = Optional.of(new Own(history, file));
        }
        show(new EditHistory(copy, vocabulary, MOST_UNDO), Optional.empty());
    }

    /** Shows the author's own project again, with its history; changes nothing where it is shown. */
    public void giveBack() {
        own.ifPresent(kept -> {
            own = Optional.empty();
            show(kept.history, kept.file);
        });
    }

    /** Whether another project is shown than the author's own. */
    public boolean isLent() {
        return own.isPresent();
    }

    /** What the author works on, also while something else is shown. */
    public Work work() {
        Own kept = own.orElseGet(() -> new Own(history, file));
        return new Work(kept.history.project(), kept.file, kept.history.isModified());
    }

    private void show(EditHistory next, Optional<Path> from) {
        Project before = project();
        Project opened = next.project();
        history = next;
        file = Objects.requireNonNull(from, "from");
        Set<String> plans = new LinkedHashSet<>();
        before.plans().forEach(p -> plans.add(p.id()));
        opened.plans().forEach(p -> plans.add(p.id()));
        tell(new DocumentChange(Cause.OPENED, before, opened, plans, List.of()));
    }

    /** The project as it is now is in this file. */
    public void saved(Path in) {
        history.markSaved();
        file = Optional.of(in);
        listeners.forEach(DocumentListener::stateChanged);
    }

    private void tell(Cause cause, Project before, EditResult.Done done) {
        tell(new DocumentChange(cause, before, done.changed(), done.touched(), done.remarks()));
    }

    private void tell(DocumentChange change) {
        listeners.forEach(listener -> listener.changed(change));
        listeners.forEach(DocumentListener::stateChanged);
    }

    /** Adds somebody who hears what becomes of it, after those who were added before. */
    public void addListener(DocumentListener listener) {
        listeners.add(Objects.requireNonNull(listener, "listener"));
    }

    /** Tells somebody no longer. */
    public void removeListener(DocumentListener listener) {
        listeners.remove(listener);
    }
}
