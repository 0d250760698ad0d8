package org.sami.spn.analysis;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.sami.spn.edit.FieldEdit;
import org.sami.spn.edit.SetReads;
import org.sami.spn.edit.VariableEdit;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.finding.Suggestions;
import org.sami.spn.model.Place;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.value.ValueType;

/** What is read has been declared, or is written somewhere in the plan (R-VAR-1). */
final class KnownVariables implements PlanCheck {
    @Override
    public List<Advice> advice() {
        return List.of(new Advice(
                "E-VARIABLE-UNKNOWN",
                "The variable has no value at any time: what reads it gets none.",
                "Correct the name, or declare the variable."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        VariableScope scope = plan.scope();
        for (VariableScope.Use read : scope.reads()) {
            if (!known(plan, scope, read.variable())) {
                report(plan, read, "reads", scope, report);
            }
        }
        for (VariableScope.Use redefined : scope.redefinitions()) {
            if (scope.declared(redefined.variable()).isEmpty() && !declaredAsRead(plan, redefined.variable())) {
                report(plan, redefined, "asks for", scope, report);
            }
        }
        for (Place place : plan.plan().places()) {
            for (int i = 0; i < place.subMissions().size(); i++) {
                checkMapping(plan, scope, place.subMissions().get(i), plan.at(place) + "/subMissions/" + i, report);
            }
        }
    }

    private static boolean known(PlanContext plan, VariableScope scope, String variable) {
        return scope.declared(variable).isPresent()
                || declaredAsRead(plan, variable)
                || scope.writes().stream().anyMatch(w -> w.variable().equals(variable));
    }

    private static boolean declaredAsRead(PlanContext plan, String variable) {
        return plan.plan().reads().contains(variable);
    }

    private static void checkMapping(
            PlanContext plan, VariableScope scope, SubMissionSpec s, String pointer, Consumer<Finding> report) {
        s.variables().forEach((child, parent) -> {
            if (!known(plan, scope, parent)) {
                report.accept(expecting(
                        plan,
                        parent,
                        Finding.error(
                                "E-VARIABLE-UNKNOWN",
                                pointer,
                                "The sub-mission \"" + plan.title(s) + "\" is given " + parent
                                        + ", which the plan neither declares nor writes"
                                        + Suggestions.meant(scope.names(), parent),
                                s.id())));
            }
        });
    }

    private static void report(
            PlanContext plan, VariableScope.Use use, String verb, VariableScope scope, Consumer<Finding> report) {
        Finding finding = Finding.error(
                "E-VARIABLE-UNKNOWN",
                use.pointer(),
                plan.eventName(use.event()) + " " + verb + " " + use.variable() + ", which nobody declares or writes"
                        + Suggestions.meant(scope.names(), use.variable()),
                use.event());
        List<String> meant = Suggestions.alike(scope.names(), use.variable()).stream()
                .filter(name -> fits(scope, name, use))
                .toList();
        Finding fixed = Fixes.meant(
                finding, meant, name -> new FieldEdit.UseVariable(plan.plan().id(), use.event(), use.variable(), name));
        report.accept(expecting(plan, use.variable(), declaring(plan, use, scope, fixed)));
    }

    /** Whether a variable is declared with the type that every field wants by which the event reads the unknown one. */
    private static boolean fits(VariableScope scope, String name, VariableScope.Use use) {
        Optional<ValueType> type = scope.declared(name);
        return type.isPresent()
                && type.equals(use.type())
                && scope.reads().stream()
                        .filter(r ->
                                r.variable().equals(use.variable()) && r.event().equals(use.event()))
                        .allMatch(r -> r.type().equals(type));
    }

    /** Offers to declare a variable where all that read it want one type, and no plan below would see it that speaks of its name. */
    private static Finding declaring(PlanContext plan, VariableScope.Use use, VariableScope scope, Finding finding) {
        List<Optional<ValueType>> types = scope.reads().stream()
                .filter(r -> r.variable().equals(use.variable()))
                .map(VariableScope.Use::type)
                .distinct()
                .toList();
        if (types.size() != 1 || types.get(0).isEmpty() || VariableScope.usedByChildren(plan, use.variable())) {
            return finding;
        }
        VariableSpec variable = new VariableSpec(use.variable(), types.get(0).get(), Optional.empty());
        return finding.fixedBy(
                "Declare " + use.variable(),
                new VariableEdit.AddVariable(Optional.of(plan.plan().id()), variable));
    }

    private static Finding expecting(PlanContext plan, String variable, Finding finding) {
        List<String> reads = new ArrayList<>(plan.plan().reads());
        reads.add(variable);
        return finding.fixedBy(
                "Expect " + variable + " of the plan's parents",
                new SetReads(plan.plan().id(), reads));
    }
}
