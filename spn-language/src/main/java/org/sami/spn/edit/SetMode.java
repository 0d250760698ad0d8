package org.sami.spn.edit;

import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.Objects;
import java.util.Set;
import org.sami.spn.model.Mode;
import org.sami.spn.model.Plan;

/** Draws vertices and edges in nominal or in recovery mode (thesis 5.1, Figure 5.2). */
public record SetMode(String plan, Set<String> elements, Mode mode) implements PlanEdit {
    public SetMode {
        Objects.requireNonNull(plan, "plan");
        Objects.requireNonNull(mode, "mode");
        elements = Collections.unmodifiableSet(new LinkedHashSet<>(elements));
    }

    @Override
    public String label() {
        return "Mark " + RemoveElements.inWords(elements) + (mode == Mode.RECOVERY ? " as recovery" : " as nominal");
    }

    @Override
    public Plan change(Plan before, EditContext context) throws EditRefusedException {
        RemoveElements.checkKnown(before, elements);
        return before.withPlaces(Parts.replaced(before.places(), p -> elements.contains(p.id()), p -> p.withMode(mode)))
                .withTransitions(
                        Parts.replaced(before.transitions(), t -> elements.contains(t.id()), t -> t.withMode(mode)))
                .withInEdges(Parts.replaced(before.inEdges(), e -> elements.contains(e.id()), e -> e.withMode(mode)))
                .withOutEdges(Parts.replaced(before.outEdges(), e -> elements.contains(e.id()), e -> e.withMode(mode)));
    }
}
