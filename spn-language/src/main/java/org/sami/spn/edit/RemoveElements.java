package org.sami.spn.edit;

import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.Objects;
import java.util.Set;
import org.sami.spn.model.Plan;

/**
 * Removes vertices, edges, events and sub-missions of one plan, by their ids. A vertex takes its edges, its point in the layout and the
 * steps of test cases that speak of it along; an event takes the steps that answer it along.
 */
public record RemoveElements(String plan, Set<String> elements) implements PlanEdit {
    public RemoveElements {
        Objects.requireNonNull(plan, "plan");
        elements = Collections.unmodifiableSet(new LinkedHashSet<>(elements));
    }

    @Override
    public String label() {
        return "Delete " + inWords(elements);
    }

    @Override
    public Plan change(Plan before, EditContext context) throws EditRefusedException {
        checkKnown(before, elements);
        return before.withPlaces(Parts.without(before.places(), p -> elements.contains(p.id())).stream()
                        .map(p -> p.withOutputs(Parts.without(p.outputs(), o -> elements.contains(o.id())))
                                .withSubMissions(Parts.without(p.subMissions(), s -> elements.contains(s.id()))))
                        .toList())
                .withTransitions(Parts.without(before.transitions(), t -> elements.contains(t.id())).stream()
                        .map(t -> t.withInputs(Parts.without(t.inputs(), i -> elements.contains(i.id()))))
                        .toList())
                .withInEdges(Parts.without(before.inEdges(), e -> elements.contains(e.id())))
                .withOutEdges(Parts.without(before.outEdges(), e -> elements.contains(e.id())));
    }

    static void checkKnown(Plan plan, Set<String> elements) throws EditRefusedException {
        Set<String> known = Parts.ids(plan);
        for (String id : elements) {
            if (!known.contains(id)) {
                throw new EditRefusedException("The plan \"" + plan.id() + "\" has no element " + id);
            }
        }
    }

    static String inWords(Set<String> elements) {
        return elements.size() == 1 ? "\"" + elements.iterator().next() + "\"" : elements.size() + " elements";
    }
}
