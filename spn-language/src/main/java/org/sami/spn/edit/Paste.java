package org.sami.spn.edit;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.stream.Stream;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.TaskSpec;
import org.sami.spn.model.Transition;
import org.sami.spn.model.VariableSpec;

/**
 * Puts a copied part into a plan, shifted. Ids that are taken there get a number, and so do names of vertices; a second start place
 * becomes an ordinary one. Variables and tasks that the part uses and the plan does not declare are declared and reported.
 *
 * @param dx to the right, in drawing units
 * @param dy downwards, in drawing units
 */
public record Paste(String plan, Fragment fragment, double dx, double dy) implements PlanEdit {
    public Paste {
        Objects.requireNonNull(plan, "plan");
        Objects.requireNonNull(fragment, "fragment");
    }

    @Override
    public String label() {
        int vertices =
                fragment.part().places().size() + fragment.part().transitions().size();
        return "Paste " + vertices + (vertices == 1 ? " vertex" : " vertices");
    }

    /** The ids that the elements of the fragment get in a plan, by the ids that they had. */
    public Map<String, String> idsIn(Plan target) {
        Set<String> taken = new HashSet<>(Parts.ids(target));
        Map<String, String> ids = new HashMap<>();
        Parts.ids(fragment.part()).stream().sorted().forEach(id -> {
            String fresh = Parts.freshId(taken, id);
            taken.add(fresh);
            ids.put(id, fresh);
        });
        return ids;
    }

    @Override
    public Plan change(Plan before, EditContext context) throws EditRefusedException {
        Map<String, String> ids = idsIn(before);
        String source = fragment.part().id();
        Plan part = PlanNames.replaced(
                fragment.part(),
                use -> use.kind() == NameUse.Kind.ELEMENT && use.of().equals(source)
                        ? ids.getOrDefault(use.name(), use.name())
                        : use.name());
        Set<String> inside = new HashSet<>();
        part.transitions().forEach(t -> inside.add(t.id()));
        Set<String> names = new HashSet<>();
        before.places().forEach(p -> names.add(p.name()));
        before.transitions().forEach(t -> names.add(t.name()));
        boolean started = before.startPlace().isPresent();
        Map<String, LayoutPoint> layout = new LinkedHashMap<>(before.layout());
        part.layout().forEach((id, at) -> layout.put(id, new LayoutPoint(at.x() + dx, at.y() + dy)));
        List<Place> places = new ArrayList<>(before.places());
        for (Place p : part.places()) {
            places.add(p.withName(freshName(names, p.name()))
                    .withStart(p.start() && !started)
                    .withTransitionOrder(Parts.without(p.transitionOrder(), t -> !inside.contains(t))));
        }
        List<Transition> transitions = new ArrayList<>(before.transitions());
        part.transitions().forEach(t -> transitions.add(t.withName(freshName(names, t.name()))));
        return declaring(before, part, context)
                .withPlaces(places)
                .withTransitions(transitions)
                .withInEdges(joined(before.inEdges(), part.inEdges()))
                .withOutEdges(joined(before.outEdges(), part.outEdges()))
                .withLayout(layout);
    }

    private static String freshName(Set<String> taken, String name) {
        String fresh = name;
        for (int n = 2; !fresh.isEmpty() && taken.contains(fresh); n++) {
            fresh = name.replaceFirst(" [0-9]+$", "") + " " + n;
        }
        taken.add(fresh);
        return fresh;
    }

    private static <T> List<T> joined(List<T> a, List<T> b) {
        return Stream.concat(a.stream(), b.stream()).toList();
    }

    private static Plan declaring(Plan target, Plan part, EditContext context) {
        List<VariableSpec> variables = new ArrayList<>(target.variables());
        for (VariableSpec v : part.variables()) {
            boolean known = target.reads().contains(v.name())
                    || target.variables().stream().anyMatch(w -> w.name().equals(v.name()));
            if (!known) {
                variables.add(v);
                context.tell(
                        "The plan \"" + target.id() + "\" now declares " + v.name() + " as \"" + part.id() + "\" does");
            }
        }
        List<TaskSpec> tasks = new ArrayList<>(target.tasks());
        for (TaskSpec t : part.tasks()) {
            if (target.tasks().stream().noneMatch(o -> o.name().equals(t.name()))) {
                tasks.add(t);
                context.tell("The plan \"" + target.id() + "\" now has the task " + t.name() + " as \"" + part.id()
                        + "\" has");
            }
        }
        return target.withVariables(variables).withTasks(tasks);
    }
}
