package org.sami.spn.analysis;

import java.util.List;
import java.util.function.Consumer;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Match;
import org.sami.spn.model.TokenKind;

/** The requirements of one edge can hold together; else its transition never fires (R-IN-3). */
final class Contradictions implements PlanCheck {
    @Override
    public List<Advice> advice() {
        return List.of(new Advice(
                "W-CONTRADICTION",
                "No marking fulfils all requirements of the edge: its transition never fires.",
                "Take away or change one of the requirements."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        for (InEdge edge : plan.plan().inEdges()) {
            List<InRequirement> all = edge.requirements();
            boolean contradiction = all.stream().anyMatch(a -> all.stream().anyMatch(b -> contradict(a, b)));
            if (contradiction) {
                report.accept(Finding.warning(
                        "W-CONTRADICTION",
                        plan.at(edge),
                        "The requirements of the " + plan.name(edge)
                                + " contradict each other: the transition never fires",
                        edge.id(),
                        edge.transition()));
            }
        }
    }

    /** Whether one wants more of a kind than the other allows of it, or of all tokens together. */
    private static boolean contradict(InRequirement wanting, InRequirement allowing) {
        boolean comparable = allowing.kind() == TokenKind.ANY_TOKEN
                ? wanting.kind() != TokenKind.UNCONDITIONAL
                : allowing.kind() == wanting.kind() && allowing.task().equals(wanting.task());
        return comparable && least(wanting) > most(allowing);
    }

    private static int least(InRequirement r) {
        return r.match() == Match.AT_LEAST || r.match() == Match.EXACTLY ? r.n() : 0;
    }

    private static int most(InRequirement r) {
        return switch (r.match()) {
            case ZERO -> 0;
            case LESS_THAN -> r.n() - 1;
            case EXACTLY -> r.n();
            case AT_LEAST, ALL -> Integer.MAX_VALUE;
        };
    }
}
