package org.sami.spn.analysis;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.sami.spn.analysis.PlanContext.PlacedInput;
import org.sami.spn.analysis.PlanContext.PlacedOutput;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;
import org.sami.spn.value.VariableReference;
import org.sami.spn.vocabulary.DecisionForm;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.FieldType;

/** Who declares, reads and writes which variable, as seen from one plan (R-VAR-1, R-VAR-2; thesis 3.1). */
final class VariableScope {
    private static final Set<DecisionForm> ASK_FOR_VARIABLES =
            EnumSet.of(DecisionForm.REDEFINE_VARIABLE, DecisionForm.DEFINE_VARIABLES);

    private final PlanContext plan;
    private final List<Use> redefinitions;
    private final List<Use> reads;
    private final List<Use> writes;

    VariableScope(PlanContext plan) {
        this.plan = plan;
        this.redefinitions = findRedefinitions();
        this.reads = findReads();
        this.writes = findWrites();
    }

    private VariableScope(PlanContext plan, VariableScope known) {
        this.plan = plan;
        this.redefinitions = known.redefinitions;
        this.reads = known.reads;
        this.writes = known.writes;
    }

    /** The same of a plan in another version of its project. */
    VariableScope in(PlanContext samePlan) {
        return new VariableScope(samePlan, this);
    }

    /** One use of a variable by a field of an event. */
    record Use(String variable, String field, Optional<ValueType> type, String pointer, String event) {}

    /** Fields that read a variable, in document order. */
    List<Use> reads() {
        return reads;
    }

    private List<Use> findReads() {
        List<Use> found = new ArrayList<>();
        for (PlacedOutput output : plan.outputs()) {
            output.spec().fields().forEach((field, source) -> {
                if (source instanceof FieldSource.FromVariable from) {
                    found.add(use(
                            from.variable(),
                            output.type(),
                            field,
                            output.pointer() + "/fields/" + field,
                            output.spec().id()));
                }
            });
        }
        return found;
    }

    /** Events that write a variable: from a field, or by asking the operator for it. */
    List<Use> writes() {
        return writes;
    }

    private List<Use> findWrites() {
        List<Use> found = new ArrayList<>();
        for (PlacedOutput output : plan.outputs()) {
            output.spec()
                    .writes()
                    .forEach((field, variable) -> found.add(use(
                            variable,
                            output.type(),
                            field,
                            output.pointer() + "/writes/" + field,
                            output.spec().id())));
        }
        for (PlacedInput input : plan.inputs()) {
            input.spec()
                    .writes()
                    .forEach((field, variable) -> found.add(use(
                            variable,
                            input.type(),
                            field,
                            input.pointer() + "/writes/" + field,
                            input.spec().id())));
        }
        found.addAll(redefinitions);
        return found;
    }

    /** Variables whose name stands in a field and which the operator is asked to redefine. */
    List<Use> redefinitions() {
        return redefinitions;
    }

    private List<Use> findRedefinitions() {
        List<Use> uses = new ArrayList<>();
        for (PlacedOutput output : plan.outputs()) {
            if (output.type()
                    .decision()
                    .filter(d -> ASK_FOR_VARIABLES.contains(d.form()))
                    .isPresent()) {
                output.spec()
                        .fields()
                        .forEach((field, source) -> named(source)
                                .forEach(variable -> uses.add(new Use(
                                        variable,
                                        field,
                                        Optional.empty(),
                                        output.pointer() + "/fields/" + field,
                                        output.spec().id()))));
            }
        }
        return uses;
    }

    private static List<String> named(FieldSource source) {
        if (!(source instanceof FieldSource.Fixed fixed)) {
            return List.of();
        }
        List<Value> values = fixed.value() instanceof ListValue list ? list.items() : List.of(fixed.value());
        return values.stream()
                .filter(VariableReference.class::isInstance)
                .map(value -> ((VariableReference) value).variable())
                .toList();
    }

    private static Use use(String variable, EventType type, String field, String pointer, String event) {
        return new Use(variable, field, type.field(field).map(FieldType::type), pointer, event);
    }

    /** The declared type: by the plan itself, by a plan that runs it, or by the project. */
    Optional<ValueType> declared(String variable) {
        return declared(plan, variable, new HashSet<>());
    }

    private static Optional<ValueType> declared(PlanContext plan, String variable, Set<String> seen) {
        Optional<ValueType> own = type(plan.plan().variables(), variable);
        if (own.isPresent() || !seen.add(plan.plan().id() + " " + variable)) {
            return own;
        }
        for (Plan parent : plan.parents()) {
            PlanContext context = plan.of(parent);
            for (SubMissionSpec s : subMissions(parent).toList()) {
                if (s.plan().equals(plan.plan().id())) {
                    Optional<ValueType> inherited =
                            declared(context, s.variables().getOrDefault(variable, variable), seen);
                    if (inherited.isPresent()) {
                        return inherited;
                    }
                }
            }
        }
        return type(plan.project().globals(), variable);
    }

    private static Optional<ValueType> type(List<VariableSpec> variables, String name) {
        return variables.stream()
                .filter(v -> v.name().equals(name))
                .map(VariableSpec::type)
                .findFirst();
    }

    /** The variables that the plan or the project declares, or that the plan writes. */
    List<String> names() {
        return Stream.of(
                        plan.plan().variables().stream().map(VariableSpec::name),
                        plan.project().globals().stream().map(VariableSpec::name),
                        plan.plan().reads().stream(),
                        writes.stream().map(Use::variable))
                .flatMap(names -> names)
                .distinct()
                .toList();
    }

    /** Whether a plan, or one that it runs, reads a variable under the name that it has there. */
    static boolean readBelow(PlanContext plan, String variable, Set<String> seen) {
        if (!seen.add(plan.plan().id() + " " + variable)) {
            return false;
        }
        VariableScope scope = plan.scope();
        return plan.plan().reads().contains(variable)
                || scope.reads().stream().anyMatch(u -> u.variable().equals(variable))
                || below(plan, variable).anyMatch(e -> readBelow(e.getKey(), e.getValue(), seen));
    }

    /** Whether a plan, or one that it runs, writes a variable under the name that it has there. */
    static boolean writtenBelow(PlanContext plan, String variable, Set<String> seen) {
        if (!seen.add(plan.plan().id() + " " + variable)) {
            return false;
        }
        VariableScope scope = plan.scope();
        return scope.writes().stream().anyMatch(u -> u.variable().equals(variable))
                || below(plan, variable).anyMatch(e -> writtenBelow(e.getKey(), e.getValue(), seen));
    }

    /** Whether a plan that this one runs, at any depth, reads or writes a variable or gives it on, under the name that it has there. */
    static boolean usedByChildren(PlanContext plan, String variable) {
        return below(plan, variable)
                .anyMatch(e -> readBelow(e.getKey(), e.getValue(), new HashSet<>())
                        || writtenBelow(e.getKey(), e.getValue(), new HashSet<>())
                        || givenBelow(e.getKey(), e.getValue(), new HashSet<>()));
    }

    private static boolean givenBelow(PlanContext plan, String variable, Set<String> seen) {
        return seen.add(plan.plan().id() + " " + variable)
                && (gives(plan, variable)
                        || below(plan, variable).anyMatch(e -> givenBelow(e.getKey(), e.getValue(), seen)));
    }

    /** Whether a plan gives a variable to a sub-mission. */
    static boolean gives(PlanContext plan, String variable) {
        return subMissions(plan.plan()).anyMatch(s -> s.variables().containsValue(variable));
    }

    /** Whether a plan that runs this one maps a variable of its own to this: then that one is the one to be written. */
    static boolean mappedAbove(PlanContext plan, String variable) {
        return plan.parents().stream()
                .flatMap(VariableScope::subMissions)
                .filter(s -> s.plan().equals(plan.plan().id()))
                .anyMatch(s -> s.variables().containsKey(variable));
    }

    /** The plans that a plan runs, with the names that a variable of the parent has in them. */
    private static Stream<Map.Entry<PlanContext, String>> below(PlanContext plan, String variable) {
        return subMissions(plan.plan())
                .flatMap(s -> plan.child(s).stream().flatMap(child -> {
                    PlanContext context = plan.of(child);
                    Stream<String> mapped = s.variables().entrySet().stream()
                            .filter(e -> e.getValue().equals(variable))
                            .map(Map.Entry::getKey);
                    boolean hidden = s.variables().containsKey(variable)
                            || child.variables().stream().anyMatch(v -> v.name().equals(variable));
                    Stream<String> same = hidden ? Stream.of() : Stream.of(variable);
                    return Stream.concat(mapped, same).map(name -> Map.entry(context, name));
                }));
    }

    static Stream<SubMissionSpec> subMissions(Plan plan) {
        return plan.places().stream().map(Place::subMissions).flatMap(List::stream);
    }
}
