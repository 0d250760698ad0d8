package org.sami.spn.analysis;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.sami.spn.edit.VariableEdit;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.value.TypeCheck;
import org.sami.spn.value.TypeNames;
import org.sami.spn.value.ValueType;

/** A variable fits every field that reads or writes it. The type of one that is not declared is that of its first write. */
final class VariableTypes implements PlanCheck {
    @Override
    public List<Advice> advice() {
        return List.of(new Advice(
                "E-VARIABLE-TYPE",
                "A value of one type is written and another is expected: the event cannot read it.",
                "Use a variable of the type of the field, or change the type of the variable."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        VariableScope scope = plan.scope();
        Map<String, ValueType> written = new LinkedHashMap<>();
        for (VariableScope.Use write : scope.writes()) {
            write.type().ifPresent(type -> {
                Optional<ValueType> variable = scope.declared(write.variable());
                ValueType target = variable.orElseGet(() -> written.computeIfAbsent(write.variable(), v -> type));
                check(plan, type, target, target, write, "is written by", report);
            });
        }
        for (VariableScope.Use read : scope.reads()) {
            Optional<ValueType> variable =
                    scope.declared(read.variable()).or(() -> Optional.ofNullable(written.get(read.variable())));
            variable.ifPresent(source ->
                    read.type().ifPresent(type -> check(plan, source, type, source, read, "is read by", report)));
        }
        for (VariableSpec v : plan.plan().variables()) {
            if (v.initial().isPresent()
                    && !TypeCheck.accepts(
                            v.type(), v.initial().get(), plan.vocabulary().types())) {
                report.accept(Finding.error(
                                "E-VARIABLE-TYPE",
                                plan.pointer() + "/variables/"
                                        + plan.plan().variables().indexOf(v),
                                "The first value of " + v.name() + " is not of its type " + TypeNames.of(v.type()),
                                v.name())
                        .fixedBy(
                                "Begin without a value",
                                new VariableEdit.ChangeVariable(
                                        Optional.of(plan.plan().id()), v.withInitial(Optional.empty()))));
            }
        }
    }

    private static void check(
            PlanContext plan,
            ValueType from,
            ValueType to,
            ValueType variable,
            VariableScope.Use use,
            String verb,
            Consumer<Finding> report) {
        if (!assignable(from, to)) {
            ValueType field = variable.equals(from) ? to : from;
            report.accept(Finding.error(
                    "E-VARIABLE-TYPE",
                    use.pointer(),
                    "The variable " + use.variable() + " is of type " + TypeNames.of(variable) + " and " + verb
                            + " a field of type " + TypeNames.of(field) + " in " + plan.eventName(use.event()),
                    use.event()));
        }
    }

    private static boolean assignable(ValueType from, ValueType to) {
        if (from.equals(to) || from == ValueType.Simple.ANY || to == ValueType.Simple.ANY) {
            return true;
        }
        if (from instanceof ValueType.ListOf a && to instanceof ValueType.ListOf b) {
            return assignable(a.element(), b.element());
        }
        if (from instanceof ValueType.MapOf a && to instanceof ValueType.MapOf b) {
            return assignable(a.key(), b.key()) && assignable(a.value(), b.value());
        }
        return from == ValueType.Simple.INTEGER && to == ValueType.Simple.REAL;
    }
}
