package org.sami.spn.wizard;

import java.util.Objects;
import org.sami.spn.edit.EditContext;
import org.sami.spn.edit.EditRefusedException;
import org.sami.spn.edit.PlanEdit;
import org.sami.spn.edit.VertexEdit;
import org.sami.spn.model.Plan;
import org.sami.spn.model.WaitFor;
import org.sami.spn.sequence.AuthoringLibrary;

/**
 * Changes whether a transition fires for each answer or waits for all, and adjusts the requirements of its edges: what fires for each leaves
 * the generic token to the others.
 */
public record ChangeWaiting(String plan, String transition, WaitFor waitFor, AuthoringLibrary library)
        implements PlanEdit {
    public ChangeWaiting {
        Objects.requireNonNull(plan, "plan");
        Objects.requireNonNull(transition, "transition");
        Objects.requireNonNull(waitFor, "waitFor");
        Objects.requireNonNull(library, "library");
    }

    @Override
    public String label() {
        return new VertexEdit.SetWaitFor(plan, transition, waitFor).label();
    }

    @Override
    public Plan change(Plan before, EditContext context) throws EditRefusedException {
        Plan changed = new VertexEdit.SetWaitFor(plan, transition, waitFor).change(before, context);
        return new RequirementComputation(context.vocabulary(), library).adjusted(before, changed);
    }
}
