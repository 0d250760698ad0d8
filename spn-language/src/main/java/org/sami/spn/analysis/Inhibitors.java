package org.sami.spn.analysis;

import java.util.List;
import java.util.function.Consumer;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Match;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;

/** A transition without input events that asks only for the absence of tokens fires as soon as somebody leaves (7.0.3). */
final class Inhibitors implements PlanCheck {
    @Override
    public List<Advice> advice() {
        return List.of(new Advice(
                "W-INHIBITORS-ONLY",
                "The transition fires before anybody has come, also at the very start.",
                "Let it also ask for somebody, at least 1, in a place before it."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        for (Transition t : plan.plan().transitions()) {
            List<InRequirement> conditions = plan.inEdges(t).stream()
                    .flatMap(e -> e.requirements().stream())
                    .filter(r -> r.kind() != TokenKind.UNCONDITIONAL)
                    .toList();
            boolean onlyAbsence = !conditions.isEmpty()
                    && conditions.stream().allMatch(r -> r.match() == Match.ZERO || r.match() == Match.LESS_THAN);
            if (t.inputs().isEmpty() && onlyAbsence) {
                report.accept(Finding.warning(
                        "W-INHIBITORS-ONLY",
                        plan.at(t),
                        "The " + plan.name(t)
                                + " asks only that tokens are absent: it also fires when nobody has been there",
                        t.id()));
            }
        }
    }
}
