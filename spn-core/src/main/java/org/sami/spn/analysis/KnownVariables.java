package org.sami.spn.analysis;

import java.util.function.Consumer;
import org.sami.spn.finding.Finding;
import org.sami.spn.finding.Suggestions;
import org.sami.spn.model.Place;
import org.sami.spn.model.SubMissionSpec;

/** What is read has been declared, or is written somewhere in the plan (R-VAR-1). */
final class KnownVariables implements PlanCheck {
    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        VariableScope scope = new VariableScope(plan);
        for (VariableScope.Use read : scope.reads()) {
            if (!known(plan, scope, read.variable())) {
                report(read, "reads", scope, report);
            }
        }
        for (VariableScope.Use redefined : scope.redefinitions()) {
            if (scope.declared(redefined.variable()).isEmpty() && !declaredAsRead(plan, redefined.variable())) {
                report(redefined, "asks for", scope, report);
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
                report.accept(Finding.error(
                        "E-VARIABLE-UNKNOWN",
                        pointer,
                        "The sub-mission " + s.id() + " is given " + parent
                                + ", which the plan neither declares nor writes"
                                + Suggestions.meant(scope.names(), parent),
                        s.id()));
            }
        });
    }

    private static void report(VariableScope.Use use, String verb, VariableScope scope, Consumer<Finding> report) {
        report.accept(Finding.error(
                "E-VARIABLE-UNKNOWN",
                use.pointer(),
                "The event " + use.event() + " " + verb + " " + use.variable() + ", which nobody declares or writes"
                        + Suggestions.meant(scope.names(), use.variable()),
                use.event()));
    }
}
