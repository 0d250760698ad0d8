package org.sami.spn.analysis;

import java.util.function.Consumer;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.OutEdge;

/**
 * Every edge has a requirement; one that wants none says unconditional (thesis 4.3.3, Token Requirements).
 *
 * <p>Implements R-OUT-8.
 */
final class EdgesWithoutRequirement implements PlanCheck {
    private static final String CODE = "E-NO-REQUIREMENT";

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        for (InEdge e : plan.plan().inEdges()) {
            if (e.requirements().isEmpty()) {
                report.accept(Finding.error(
                        CODE,
                        plan.at(e),
                        "The edge from " + e.place() + " to " + e.transition() + " has no requirement",
                        e.id()));
            }
        }
        for (OutEdge e : plan.plan().outEdges()) {
            if (e.requirements().isEmpty()) {
                report.accept(Finding.error(
                        CODE,
                        plan.at(e),
                        "The edge from " + e.transition() + " to " + e.place() + " has no requirement",
                        e.id()));
            }
        }
    }
}
