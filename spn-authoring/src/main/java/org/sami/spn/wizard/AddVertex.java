package org.sami.spn.wizard;

import java.util.Objects;
import java.util.Optional;
import org.sami.spn.edit.EditContext;
import org.sami.spn.edit.EditRefusedException;
import org.sami.spn.edit.PlanEdit;
import org.sami.spn.model.Mode;
import org.sami.spn.model.Plan;
import org.sami.spn.sequence.AuthoringLibrary;

/**
 * Adds a blank place or transition, or a place that runs a sub-mission, with the edge that leads to it, and adjusts the requirements of
 * edges; one step to undo.
 *
 * @param target a sub-mission also goes onto a place that is there
 * @param mode in which new vertices and edges are drawn
 */
public record AddVertex(String plan, Content content, EventTarget target, Mode mode, AuthoringLibrary library)
        implements PlanEdit {
    /** What is added. */
    public sealed interface Content {
        /** A blank place. */
        record BlankPlace() implements Content {}

        /** A blank transition. */
        record BlankTransition() implements Content {}

        /**
         * A place that runs a plan, once for each visit until the author says otherwise.
         *
         * @param plan its id
         * @param name of the place, where one is drawn
         */
        record SubMission(String plan, String name) implements Content {
            public SubMission {
                Objects.requireNonNull(plan, "plan");
                Objects.requireNonNull(name, "name");
            }
        }
    }

    public AddVertex {
        Objects.requireNonNull(plan, "plan");
        Objects.requireNonNull(content, "content");
        Objects.requireNonNull(target, "target");
        Objects.requireNonNull(mode, "mode");
        Objects.requireNonNull(library, "library");
    }

    @Override
    public String label() {
        if (content instanceof Content.SubMission sub) {
            return "Run \"" + sub.plan() + "\""
                    + (target instanceof EventTarget.OnVertex on ? " at \"" + on.vertex() + "\"" : "");
        }
        return content instanceof Content.BlankPlace ? "Add a place" : "Add a transition";
    }

    /** Why it cannot be added here, in one sentence; empty where it can. */
    public static Optional<String> refusal(Plan plan, Content content, EventTarget target) {
        if (!(target instanceof EventTarget.OnVertex on)) {
            return Optional.empty();
        }
        if (!(content instanceof Content.SubMission)) {
            return Optional.of("A blank vertex goes onto free space, or behind another vertex");
        }
        return plan.place(on.vertex()).isPresent()
                ? Optional.empty()
                : Optional.of("A sub-mission stands on a place, and " + on.vertex() + " is none");
    }

    @Override
    public Plan change(Plan before, EditContext context) throws EditRefusedException {
        Optional<String> refusal = refusal(before, content, target);
        if (refusal.isPresent()) {
            throw new EditRefusedException(refusal.get());
        }
        Growth growth = new Growth(before, context.vocabulary(), library, mode);
        boolean place = !(content instanceof Content.BlankTransition);
        String name = content instanceof Content.SubMission sub ? sub.name() : "";
        String vertex = Placement.vertex(growth, target, place, name);
        if (content instanceof Content.SubMission sub) {
            growth.subMission(vertex, sub.plan());
        } else if (target instanceof EventTarget.Free) {
            return growth.plan(); // joins nothing: what other edges need is the same as before
        }
        return new RequirementComputation(context.vocabulary(), library).adjusted(before, growth.plan());
    }
}
