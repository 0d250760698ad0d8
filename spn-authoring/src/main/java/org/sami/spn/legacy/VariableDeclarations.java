package org.sami.spn.legacy;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.model.Transition;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.Reserved;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Declares the variables of imported plans. In the earlier system a variable was a name shared by all its users; here it
 * belongs to the project or to a plan and is seen by the sub-missions below. So a name that is no global is declared by the
 * topmost plan that uses it, with the type of the fields that write or read it.
 */
final class VariableDeclarations {
    private final Vocabulary vocabulary;
    private final LegacyValues values;
    private final Map<String, Double> units;
    private final LegacyProject source;
    private final List<Plan> plans;
    private final Findings findings;
    private final Set<String> globals = new LinkedHashSet<>();

    VariableDeclarations(
            Vocabulary vocabulary,
            LegacyValues values,
            Map<String, Double> units,
            LegacyProject source,
            List<Plan> plans,
            Findings findings) {
        this.vocabulary = vocabulary;
        this.values = values;
        this.units = units;
        this.source = source;
        this.plans = plans;
        this.findings = findings;
        source.globals().forEach(g -> globals.add(g.name()));
    }

    /** The global variables with their values. */
    List<VariableSpec> globals() {
        return source.globals().stream().map(this::global).toList();
    }

    private VariableSpec global(LegacyProject.Global g) {
        Optional<ValueType> used = plans.stream()
                .flatMap(p -> uses(p).stream())
                .filter(u -> u.variable().equals(g.name()))
                .flatMap(u -> u.type().stream())
                .findFirst();
        Optional<ValueType> own = g.value().flatMap(values::naturalType);
        LegacyTable.FieldRule rule =
                new LegacyTable.FieldRule("", units.getOrDefault(g.name(), 1.0), Map.of(), false, "", Set.of());
        for (Optional<ValueType> type : List.of(used, own)) {
            Optional<Value> value = type.flatMap(t -> g.value().flatMap(v -> values.convert(v, t, rule)));
            if (value.isPresent() || (type.isPresent() && g.value().isEmpty())) {
                return new VariableSpec(g.name(), type.get(), value);
            }
        }
        findings.warning(
                LegacyCodes.VALUE,
                g.pointer(),
                "The value of the global variable " + g.name() + " of the class " + g.className()
                        + " cannot be one here; it is declared without it",
                g.name());
        return new VariableSpec(g.name(), used.or(() -> own).orElse(ValueType.Simple.ANY), Optional.empty());
    }

    /** The plan with the variables that it declares, and those that it expects from above. */
    Plan declare(Plan plan) {
        Set<String> names = new LinkedHashSet<>(Counts.variables(plan));
        plan.places().stream()
                .flatMap(p -> p.subMissions().stream())
                .forEach(s -> names.addAll(s.variables().values()));
        names.removeAll(globals);
        names.remove(Reserved.TASK_VARIABLE);
        List<VariableSpec> variables = new ArrayList<>();
        List<String> reads = new ArrayList<>();
        for (String name : names) {
            if (usedAbove(plan, name, new LinkedHashSet<>())) {
                reads.add(name);
            } else {
                variables.add(new VariableSpec(name, type(plan, name), Optional.empty()));
            }
        }
        return plan.withVariables(variables).withReads(reads);
    }

    /** Whether a plan that runs this one, at any depth and under whatever name, uses the variable too. */
    private boolean usedAbove(Plan plan, String name, Set<String> seen) {
        if (!seen.add(plan.id() + " " + name)) {
            return false;
        }
        for (Plan parent : plans) {
            for (SubMissionSpec s : subMissions(parent)) {
                String above = s.variables().getOrDefault(name, name);
                if (s.plan().equals(plan.id())
                        && !s.variables().containsKey(name)
                        && (Counts.variables(parent).contains(above) || usedAbove(parent, above, seen))) {
                    return true;
                }
            }
        }
        return false;
    }

    private static List<SubMissionSpec> subMissions(Plan plan) {
        return plan.places().stream().flatMap(p -> p.subMissions().stream()).toList();
    }

    /** What the plan's own fields say, those that write first; then what any plan's say of the name. */
    private ValueType type(Plan plan, String name) {
        List<Use> all = new ArrayList<>(uses(plan));
        plans.stream().filter(p -> !p.id().equals(plan.id())).forEach(p -> all.addAll(uses(p)));
        List<ValueType> types = all.stream()
                .filter(u -> u.variable().equals(name))
                .sorted((a, b) -> Boolean.compare(b.writes(), a.writes()))
                .flatMap(u -> u.type().stream())
                .distinct()
                .toList();
        if (types.size() > 1) {
            findings.warning(
                    LegacyCodes.VARIABLE_TYPE,
                    pointer(plan),
                    "The plan " + plan.id() + " uses " + name + " for values of several types: " + types,
                    plan.id(),
                    name);
        }
        tellIfOnlyNamed(plan, name);
        return types.isEmpty()
                ? namesake(plan, name).map(n -> typeOf(all, n)).orElse(ValueType.Simple.ANY)
                : types.get(0);
    }

    /** A name that a redefinition asks for, and that no field of the plan or of what it runs reads or writes. */
    private void tellIfOnlyNamed(Plan plan, String name) {
        if (family(plan, new LinkedHashSet<>()).stream()
                .flatMap(p -> uses(p).stream())
                .anyMatch(u -> u.variable().equals(name))) {
            return;
        }
        Optional<String> namesake = namesake(plan, name);
        findings.warning(
                namesake.isPresent() ? LegacyCodes.PREFIX : LegacyCodes.VARIABLE,
                pointer(plan),
                "The plan " + plan.id() + " (" + plan.name() + ") names the variable " + name
                        + ", which no field of it reads or writes"
                        + namesake.map(n -> "; its prefix is missing, " + n + " is meant")
                                .orElse("")
                        + ". It is imported as it stands: giving it a value changes nothing",
                plan.id(),
                name);
    }

    /** The variable of the plan that has the same name behind a prefix. */
    private Optional<String> namesake(Plan plan, String name) {
        return uses(plan).stream()
                .map(Use::variable)
                .filter(v -> v.endsWith("." + name.substring(1)))
                .findFirst();
    }

    /** The plan, and what it runs. */
    private List<Plan> family(Plan plan, Set<String> seen) {
        List<Plan> family = new ArrayList<>();
        if (seen.add(plan.id())) {
            family.add(plan);
            for (SubMissionSpec s : subMissions(plan)) {
                plans.stream().filter(p -> p.id().equals(s.plan())).forEach(p -> family.addAll(family(p, seen)));
            }
        }
        return family;
    }

    private static ValueType typeOf(List<Use> uses, String name) {
        return uses.stream()
                .filter(u -> u.variable().equals(name))
                .flatMap(u -> u.type().stream())
                .findFirst()
                .orElse(ValueType.Simple.ANY);
    }

    private String pointer(Plan plan) {
        return source.plan(plan.id()).map(LegacyPlan::pointer).orElse("");
    }

    /** One use of a variable by a field; the type is empty where the field only names it. */
    private record Use(String variable, Optional<ValueType> type, boolean writes) {
        Use {
            Objects.requireNonNull(variable, "variable");
        }
    }

    private List<Use> uses(Plan plan) {
        List<Use> uses = new ArrayList<>();
        for (Place place : plan.places()) {
            for (OutputEventSpec e : place.outputs()) {
                e.fields().forEach((field, from) -> {
                    if (from instanceof FieldSource.FromVariable v) {
                        uses.add(new Use(v.variable(), fieldType(e.type(), field), false));
                    }
                });
                e.writes().forEach((field, v) -> uses.add(new Use(v, fieldType(e.type(), field), true)));
            }
        }
        for (Transition t : plan.transitions()) {
            t.inputs()
                    .forEach(e ->
                            e.writes().forEach((field, v) -> uses.add(new Use(v, fieldType(e.type(), field), true))));
        }
        Map<String, String> mapped = new LinkedHashMap<>();
        subMissions(plan)
                .forEach(s -> s.variables().forEach((child, parent) -> mapped.put(parent, s.plan() + " " + child)));
        mapped.forEach((parent, child) -> {
            String planId = child.substring(0, child.indexOf(' '));
            plans.stream()
                    .filter(p -> p.id().equals(planId) && !planId.equals(plan.id()))
                    .flatMap(p -> uses(p).stream())
                    .filter(u -> u.variable().equals(child.substring(child.indexOf(' ') + 1)))
                    .forEach(u -> uses.add(new Use(parent, u.type(), u.writes())));
        });
        return uses;
    }

    private Optional<ValueType> fieldType(String event, String field) {
        return vocabulary.event(event).flatMap(t -> t.field(field)).map(FieldType::type);
    }
}
