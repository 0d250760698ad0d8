package org.sami.spn.edit;

import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.Objects;
import java.util.Set;
import org.sami.spn.model.Plan;

/** Disables places and transitions for trying, or enables them again. Edges among the elements stay as they are. */
public record SetDisabled(String plan, Set<String> elements, boolean disabled) implements PlanEdit {
    public SetDisabled {
        Objects.requireNonNull(plan, "plan");
        elements = Collections.unmodifiableSet(new LinkedHashSet<>(elements));
    }

    @Override
    public String label() {
        return (disabled ? "Disable " : "Enable ") + RemoveElements.inWords(elements);
    }

    @Override
    public Plan change(Plan before, EditContext context) throws EditRefusedException {
        RemoveElements.checkKnown(before, elements);
        return before.withPlaces(
                        Parts.replaced(before.places(), p -> elements.contains(p.id()), p -> p.withDisabled(disabled)))
                .withTransitions(Parts.replaced(
                        before.transitions(), t -> elements.contains(t.id()), t -> t.withDisabled(disabled)));
    }
}
