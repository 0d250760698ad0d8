package org.sami.spn.edit;

import java.util.List;
import java.util.Objects;
import org.sami.spn.model.Plan;

/** Sets the names of the variables that a plan expects of its parents or the project. */
public record SetReads(String plan, List<String> variables) implements PlanEdit {
    public SetReads {
        Objects.requireNonNull(plan, "plan");
        variables = List.copyOf(variables);
    }

    @Override
    public String label() {
        return "Change variables that \"" + plan + "\" expects";
    }

    @Override
    public Plan change(Plan before, EditContext context) {
        return before.withReads(variables);
    }
}
