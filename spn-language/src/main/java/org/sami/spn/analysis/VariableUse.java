package org.sami.spn.analysis;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.EditSequence;
import org.sami.spn.edit.FieldEdit;
import org.sami.spn.edit.VariableEdit;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.VariableSpec;

/** What a plan keeps to itself is both written and read (R-VAR-1). What it shares may be read elsewhere. */
final class VariableUse implements PlanCheck {
    @Override
    public List<Advice> advice() {
        return List.of(
                new Advice(
                        "W-VARIABLE-NEVER-WRITTEN",
                        "The variable is read and never has a value: what reads it fails or waits.",
                        "Let an answer write it, or give it a first value."),
                new Advice(
                        "W-VARIABLE-UNREAD",
                        "The value is kept for nobody: an event that was to use it uses something else.",
                        "Let the event read the variable that is to use it, or stop writing it."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        VariableScope scope = plan.scope();
        List<VariableSpec> own = plan.plan().variables();
        for (int i = 0; i < own.size(); i++) {
            checkDeclared(plan, scope, own.get(i), plan.pointer() + "/variables/" + i, report);
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
                report.accept(notWritten(plan, scope, unread(variable, write.pointer(), write.event()), variable));
            }
        });
    }

    private static void checkDeclared(
            PlanContext plan, VariableScope scope, VariableSpec v, String pointer, Consumer<Finding> report) {
        boolean read = VariableScope.readBelow(plan, v.name(), new HashSet<>());
        boolean written = VariableScope.writtenBelow(plan, v.name(), new HashSet<>());
        if (!read) {
            report.accept(notDeclared(plan, scope, unread(v.name(), pointer, v.name()), v.name()));
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

    /** Offers to remove a declaration with what writes it, where nothing but fields of this plan's events does. */
    private static Finding notDeclared(PlanContext plan, VariableScope scope, Finding finding, String variable) {
        if (isAskedFor(scope, variable)
                || VariableScope.gives(plan, variable)
                || VariableScope.usedByChildren(plan, variable)) {
            return finding;
        }
        List<Edit> edits = new ArrayList<>(notWriting(plan, scope, variable));
        edits.add(new VariableEdit.RemoveVariable(Optional.of(plan.plan().id()), variable));
        return finding.fixedBy("Remove " + variable, new EditSequence("Remove " + variable, edits));
    }

    private static Finding notWritten(PlanContext plan, VariableScope scope, Finding finding, String variable) {
        return isAskedFor(scope, variable) || VariableScope.gives(plan, variable)
                ? finding
                : finding.fixedBy(
                        "Stop writing " + variable,
                        new EditSequence("Stop writing " + variable, notWriting(plan, scope, variable)));
    }

    private static boolean isAskedFor(VariableScope scope, String variable) {
        return scope.redefinitions().stream().anyMatch(u -> u.variable().equals(variable));
    }

    private static List<Edit> notWriting(PlanContext plan, VariableScope scope, String variable) {
        List<Edit> edits = new ArrayList<>();
        for (VariableScope.Use write : scope.writes()) {
            if (write.variable().equals(variable)) {
                edits.add(new FieldEdit.ClearWrite(plan.plan().id(), write.event(), write.field()));
            }
        }
        return edits;
    }
}
