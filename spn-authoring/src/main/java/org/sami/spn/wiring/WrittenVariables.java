package org.sami.spn.wiring;

import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.model.Transition;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;
import org.sami.spn.value.VariableReference;

/** Which variables the vertices of a plan write, and of which types variables are. */
final class WrittenVariables {
    private final Project project;

    WrittenVariables(Project project) {
        this.project = project;
    }

    /** What a place writes while robots are there: fields of its events, what it asks the operator for, what its sub-missions write. */
    Set<String> by(Place place) {
        Set<String> written = new LinkedHashSet<>();
        for (OutputEventSpec output : place.outputs()) {
            written.addAll(output.writes().values());
            output.fields().values().forEach(source -> written.addAll(askedFor(source)));
        }
        place.subMissions().forEach(s -> written.addAll(bySubMission(s, new HashSet<>())));
        return written;
    }

    /** What a firing writes. */
    Set<String> by(Transition transition) {
        Set<String> written = new LinkedHashSet<>();
        transition.inputs().forEach(i -> written.addAll(i.writes().values()));
        return written;
    }

    /** Variables that stand as values in a field: the operator is asked for them. */
    private static List<String> askedFor(FieldSource source) {
        if (!(source instanceof FieldSource.Fixed fixed)) {
            return List.of();
        }
        List<Value> values = fixed.value() instanceof ListValue list ? list.items() : List.of(fixed.value());
        return values.stream()
                .filter(VariableReference.class::isInstance)
                .map(value -> ((VariableReference) value).variable())
                .toList();
    }

    /** The parent's names of what a sub-mission writes. */
    private Set<String> bySubMission(SubMissionSpec sub, Set<String> seen) {
        Set<String> written = new LinkedHashSet<>();
        Optional<Plan> child = project.plan(sub.plan());
        if (child.isEmpty() || !seen.add(sub.plan())) {
            return written;
        }
        Set<String> below = new LinkedHashSet<>();
        child.get().transitions().forEach(t -> below.addAll(by(t)));
        for (Place place : child.get().places()) {
            place.outputs().forEach(o -> below.addAll(o.writes().values()));
            place.subMissions().forEach(s -> below.addAll(bySubMission(s, seen)));
        }
        for (String name : below) {
            if (sub.variables().containsKey(name)) {
                written.add(sub.variables().get(name));
            } else if (declared(child.get().variables(), name).isEmpty()) {
                written.add(name);
            }
        }
        return written;
    }

    /** The type of a variable as a plan sees it: its own, its parents', the project's; empty where nobody declares it. */
    Optional<ValueType> type(Plan plan, String name) {
        return type(plan, name, new HashSet<>());
    }

    private Optional<ValueType> type(Plan plan, String name, Set<String> seen) {
        Optional<ValueType> own = declared(plan.variables(), name);
        if (own.isPresent() || !seen.add(plan.id() + " " + name)) {
            return own;
        }
        for (Plan parent : project.plans()) {
            for (Map.Entry<String, String> above : namesAbove(parent, plan, name)) {
                Optional<ValueType> inherited = type(parent, above.getValue(), seen);
                if (inherited.isPresent()) {
                    return inherited;
                }
            }
        }
        return declared(project.globals(), name);
    }

    private static List<Map.Entry<String, String>> namesAbove(Plan parent, Plan child, String name) {
        return parent.places().stream()
                .flatMap(p -> p.subMissions().stream())
                .filter(s -> s.plan().equals(child.id()))
                .map(s -> Map.entry(s.id(), s.variables().getOrDefault(name, name)))
                .toList();
    }

    private static Optional<ValueType> declared(List<VariableSpec> variables, String name) {
        return variables.stream()
                .filter(v -> v.name().equals(name))
                .map(VariableSpec::type)
                .findFirst();
    }
}
