package org.sami.lessons.script;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.EditHistory;
import org.sami.spn.edit.EditResult;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.sequence.AuthoringLibrary;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * What came of a script: the project after each of its elements.
 *
 * @param start the project as it was
 * @param done the elements that were done, in their order
 * @param refusal the element that could not be done; empty where all were
 */
public record ScriptRun(Project start, List<Done> done, Optional<Refusal> refusal) {
    private static final int MOST_UNDO = 1000;

    /**
     * An element that was done.
     *
     * @param edit the edit that it is; empty where it changes nothing, or takes back and makes again
     * @param plan id of the plan that is open afterwards; empty where the project has none
     * @param project as it is afterwards
     */
    public record Done(ScriptElement element, Optional<Edit> edit, Optional<String> plan, Project project) {}

    /**
     * An element that could not be done.
     *
     * @param index of the element, from 0
     * @param pointer of what is in the way, from the list of elements, such as {@code /3/source}
     * @param message a sentence that names the element and what is in the way
     */
    public record Refusal(int index, String pointer, String message) {}

    public ScriptRun {
        Objects.requireNonNull(start, "start");
        done = List.copyOf(done);
        Objects.requireNonNull(refusal, "refusal");
    }

    /** The project after the last element that was done. */
    public Project project() {
        return done.isEmpty() ? start : done.get(done.size() - 1).project();
    }

    /**
     * The project after all elements.
     *
     * @throws IllegalArgumentException naming the element that could not be done
     */
    public Project orThrow() {
        if (refusal.isPresent()) {
            throw new IllegalArgumentException(refusal.get().message());
        }
        return project();
    }

    static ScriptRun of(List<ScriptElement> script, Project start, Vocabulary vocabulary, AuthoringLibrary library) {
        EditHistory history = new EditHistory(start, vocabulary, MOST_UNDO);
        ScriptEdits edits = new ScriptEdits(vocabulary, library);
        Optional<String> open = start.plans().stream().map(Plan::id).findFirst();
        List<Done> done = new ArrayList<>();
        for (ScriptElement element : script) {
            try {
                Optional<Edit> edit = edits.edit(element, history.project(), open);
                if (edit.isPresent() && history.apply(edit.get()) instanceof EditResult.Refused refused) {
                    throw new ScriptRefusedException("", refused.message());
                }
                command(element, history);
                open = open(element, open);
                done.add(new Done(element, edit, open, history.project()));
            } catch (ScriptRefusedException e) {
                int index = done.size();
                String message = "Element " + (index + 1) + " of the script (" + element.title() + "): " + e.reason();
                Refusal refusal = new Refusal(index, "/" + index + e.pointer(), message);
                return new ScriptRun(start, done, Optional.of(refusal));
            }
        }
        return new ScriptRun(start, done, Optional.empty());
    }

    private static void command(ScriptElement element, EditHistory history) throws ScriptRefusedException {
        if (element instanceof ScriptElement.Give give) {
            boolean nothing = (give.id().equals("undo") && history.undo().isEmpty())
                    || (give.id().equals("redo") && history.redo().isEmpty());
            if (nothing) {
                throw new ScriptRefusedException("/id", "There is nothing to " + give.id());
            }
        }
    }

    private static Optional<String> open(ScriptElement element, Optional<String> open) {
        if (element instanceof ScriptElement.NewPlan made) {
            return Optional.of(made.id());
        }
        return element instanceof ScriptElement.OpenPlan other ? Optional.of(other.id()) : open;
    }
}
