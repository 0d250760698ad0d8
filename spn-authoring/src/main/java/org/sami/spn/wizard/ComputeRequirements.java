package org.sami.spn.wizard;

import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.Objects;
import java.util.Set;
import org.sami.spn.edit.EditContext;
import org.sami.spn.edit.PlanEdit;
import org.sami.spn.model.Plan;
import org.sami.spn.sequence.AuthoringLibrary;

/** Computes the requirements of some edges again, whatever was written on them; locked ones keep theirs. */
public record ComputeRequirements(String plan, Set<String> edges, AuthoringLibrary library) implements PlanEdit {
    public ComputeRequirements {
        Objects.requireNonNull(plan, "plan");
        edges = Collections.unmodifiableSet(new LinkedHashSet<>(edges));
        Objects.requireNonNull(library, "library");
    }

    @Override
    public String label() {
        return "Compute requirements of " + (edges.size() == 1 ? "an edge" : edges.size() + " edges");
    }

    @Override
    public Plan change(Plan before, EditContext context) {
        return new RequirementComputation(context.vocabulary(), library).computed(before, edges);
    }
}
