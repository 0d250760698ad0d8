package org.sami.spn.edit;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.sami.spn.model.Project;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * A project with the versions that it had, for undo and redo. Versions share what did not change, so that a long history is small. Not for
 * several threads: a window keeps it on its event thread.
 */
public final class EditHistory {
    private final Vocabulary vocabulary;
    private final int mostUndo;
    private final Deque<Version> undo = new ArrayDeque<>();
    private final Deque<Version> redo = new ArrayDeque<>();
    private Project current;
    private Project saved;

    /**
     * The history of a project as it was opened, which counts as saved.
     *
     * @param mostUndo how many edits can be undone; older ones are forgotten
     */
    public EditHistory(Project opened, Vocabulary vocabulary, int mostUndo) {
        this.current = Objects.requireNonNull(opened, "opened");
        this.saved = opened;
        this.vocabulary = Objects.requireNonNull(vocabulary, "vocabulary");
        if (mostUndo < 1) {
            throw new IllegalArgumentException("At least one edit can be undone, not " + mostUndo);
        }
        this.mostUndo = mostUndo;
    }

    /** The project as it is now. */
    public Project project() {
        return current;
    }

    /** Applies an edit. One that is refused, or changes nothing, leaves the history as it is. */
    public EditResult apply(Edit edit) {
        EditResult result = edit.apply(current, vocabulary);
        result.project().filter(changed -> !changed.equals(current)).ifPresent(changed -> {
            undo.push(new Version(edit.label(), current));
            while (undo.size() > mostUndo) {
                undo.removeLast();
            }
            redo.clear();
            current = changed;
        });
        return result;
    }

    /** What the next undo takes back, in words; empty where there is nothing. */
    public Optional<String> undoLabel() {
        return Optional.ofNullable(undo.peek()).map(Version::label);
    }

    /** What the next redo makes again, in words; empty where there is nothing. */
    public Optional<String> redoLabel() {
        return Optional.ofNullable(redo.peek()).map(Version::label);
    }

    /** Undoes the last edit; the plans that differ then are reported as those of an edit. Empty where there is nothing to undo. */
    public Optional<EditResult.Done> undo() {
        return step(undo, redo);
    }

    /** Makes the edit again that was undone last. Empty where there is nothing to redo. */
    public Optional<EditResult.Done> redo() {
        return step(redo, undo);
    }

    private Optional<EditResult.Done> step(Deque<Version> from, Deque<Version> to) {
        Optional<Version> version = Optional.ofNullable(from.poll());
        return version.map(v -> {
            Project before = current;
            to.push(new Version(v.label, before));
            current = v.project;
            return EditResult.Done.of(before, current, List.of());
        });
    }

    /** Marks the project as it is now as saved. */
    public void markSaved() {
        saved = current;
    }

    /** Whether the project differs from what was saved or opened last. */
    public boolean isModified() {
        return !current.equals(saved);
    }

    /** A project that was, and the edit that lies between it and the next. */
    private record Version(String label, Project project) {}
}
