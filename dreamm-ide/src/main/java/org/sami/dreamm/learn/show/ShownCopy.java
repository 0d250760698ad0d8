package org.sami.dreamm.learn.show;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.sami.dreamm.document.EditorState;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.lessons.script.ScriptElement;
import org.sami.lessons.script.ScriptRun;
import org.sami.picture.net.NetMode;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.EditContext;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;

/**
 * The copy on which edits are shown, in place of the author's own project, and what the author looked at before. Knows no Swing. On the event
 * thread.
 */
final class ShownCopy {
    private final ProjectDocument document;
    private final EditorState editor;
    private final Optional<String> plan;
    private final Set<String> selection;
    private final NetMode mode;
    private int shown;

    /** Shows a copy. */
    ShownCopy(ProjectDocument document, EditorState editor, Project copy) {
        this.document = Objects.requireNonNull(document, "document");
        this.editor = Objects.requireNonNull(editor, "editor");
        plan = editor.planId();
        selection = editor.selection();
        mode = editor.mode();
        document.lend(copy);
    }

    /** How many edits are shown. */
    int shown() {
        return shown;
    }

    /** Shows the author's own project again, and of it what was looked at before. */
    void giveBack() {
        document.giveBack();
        editor.setMode(mode);
        plan.ifPresent(id -> editor.open(id, selection));
    }

    /**
     * Brings the copy to where the model is.
     *
     * @return the ids of the vertices that were added, where one edit was made
     */
    Set<String> show(ShowMeModel model) {
        Optional<Plan> before = editor.plan();
        Optional<ScriptRun.Done> made = model.done() == shown + 1 ? model.last() : Optional.empty();
        shown = model.done();
        if (!document.project().equals(model.project())) {
            made.flatMap(ScriptRun.Done::edit).ifPresent(document::apply);
            if (!document.project().equals(model.project())) {
                document.apply(new Stand(model.project()));
            }
        }
        model.plan().map(Plan::id).ifPresent(editor::open);
        Set<String> added = before.isPresent() && made.isPresent() ? added(before.get()) : Set.of();
        if (!added.isEmpty()) {
            editor.select(List.of(added.iterator().next()));
        } else if (made.map(ScriptRun.Done::element).orElse(null) instanceof ScriptElement.Select select) {
            editor.select(select.what());
        }
        return added;
    }

    private Set<String> added(Plan before) {
        Set<String> added = new LinkedHashSet<>();
        editor.plan().filter(now -> now.id().equals(before.id())).ifPresent(now -> {
            now.places().stream().filter(p -> before.place(p.id()).isEmpty()).forEach(p -> added.add(p.id()));
            now.transitions().stream()
                    .filter(t -> before.transition(t.id()).isEmpty())
                    .forEach(t -> added.add(t.id()));
        });
        return added;
    }

    /** The copy as it is at one edit of the script. */
    private record Stand(Project next) implements Edit {
        @Override
        public String label() {
            return "Show another edit";
        }

        @Override
        public Project change(Project project, EditContext context) {
            return next;
        }
    }
}
