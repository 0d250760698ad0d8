package org.sami.spn.analysis;

import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.VariableSpec;

/** What a plan keeps to itself is both written and read (R-VAR-1). What it shares may be read elsewhere. */
final class VariableUse implements PlanCheck {
    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        VariableScope scope = new VariableScope(plan);
        List<VariableSpec> own = plan.plan().variables();
        for (int i = 0; i < own.size(); i++) {
            checkDeclared(plan, own.get(i), plan.pointer() + "/variables/" + i, report);
        }
        Map<String, VariableScope.Use> undeclared = new LinkedHashMap<>();
        for (VariableScope.Use write : scope.writes()) {
            if (scope.declared(write.variable()).isEmpty()
                    && !plan.plan().reads().contains(write.variable())) {
                undeclared.putIfAbsent(write.variable(), write);
            }
        }
        undeclared.forEach((variable, write) -> {
            if (!VariableScope.readBelow(plan, variable, new HashSet<>())) {
                report.accept(unread(variable, write.pointer(), write.event()));
            }
        });
    }

    private static void checkDeclared(PlanContext plan, VariableSpec v, String pointer, Consumer<Finding> report) {
        boolean read = VariableScope.readBelow(plan, v.name(), new HashSet<>());
        boolean written = VariableScope.writtenBelow(plan, v.name(), new HashSet<>());
        if (!read) {
            report.accept(unread(v.name(), pointer, v.name()));
        } else if (!written && v.initial().isEmpty() && !VariableScope.mappedAbove(plan, v.name())) {
            report.accept(Finding.warning(
                    "W-VARIABLE-NEVER-WRITTEN",
                    pointer,
                    "The variable " + v.name() + " is read, but has no first value and nothing writes it",
                    v.name()));
        }
    }

    private static Finding unread(String variable, String pointer, String element) {
        return Finding.warning("W-VARIABLE-UNREAD", pointer, "The variable " + variable + " is never read", element);
    }
}
