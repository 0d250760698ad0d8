package org.sami.spn.edit;

import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Plan;

/**
 * A copied part of a plan: vertices with their events and sub-missions, the edges between them, where they are drawn, and the declarations
 * of the variables and tasks that they speak of.
 *
 * @param part these as a plan of their own, under the id of the plan that they come from
 */
public record Fragment(Plan part) {
    public Fragment {
        Objects.requireNonNull(part, "part");
    }

    /** Copies the vertices of a plan that are among some ids; other ids in it, such as those of edges, are passed over. */
    public static Fragment copyOf(Plan plan, Set<String> ids) {
        Map<String, LayoutPoint> layout = new LinkedHashMap<>(plan.layout());
        layout.keySet().retainAll(ids);
        Plan vertices = plan.withPlaces(Parts.without(plan.places(), p -> !ids.contains(p.id())))
                .withTransitions(Parts.without(plan.transitions(), t -> !ids.contains(t.id())))
                .withInEdges(
                        Parts.without(plan.inEdges(), e -> !ids.contains(e.place()) || !ids.contains(e.transition())))
                .withOutEdges(
                        Parts.without(plan.outEdges(), e -> !ids.contains(e.place()) || !ids.contains(e.transition())))
                .withLayout(layout)
                .withNotes(List.of())
                .withFrames(List.of())
                .withTestCases(List.of())
                .withQueries(List.of())
                .withReads(List.of())
                .withVariables(List.of())
                .withTasks(List.of());
        Set<NameUse> used = new HashSet<>();
        PlanNames.forEach(vertices, use -> used.add(new NameUse(use.kind(), use.name(), use.of(), "", "")));
        return new Fragment(vertices.withVariables(Parts.without(
                        plan.variables(),
                        v -> !used.contains(new NameUse(NameUse.Kind.VARIABLE, v.name(), plan.id(), "", ""))))
                .withTasks(Parts.without(
                        plan.tasks(),
                        t -> !used.contains(new NameUse(NameUse.Kind.TASK, t.name(), plan.id(), "", "")))));
    }

    /** Whether nothing was copied. */
    public boolean isEmpty() {
        return part.places().isEmpty() && part.transitions().isEmpty();
    }
}
