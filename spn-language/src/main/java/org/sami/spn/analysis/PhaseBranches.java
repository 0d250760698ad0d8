package org.sami.spn.analysis;

import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.sami.spn.analysis.PlanContext.PlacedInput;
import org.sami.spn.analysis.PlanContext.PlacedOutput;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.phase.PhaseAction;
import org.sami.spn.phase.PhaseChart;

/** A branch of the phase chart is an option of an action before it; without one nobody can see it (thesis 5.2.3). */
final class PhaseBranches implements PlanCheck {
    @Override
    public List<Advice> advice() {
        return List.of(new Advice(
                "W-PHASE-BRANCH",
                "The phase chart has no action to put the branch on, so it does not show it.",
                "Put a Phase Item on a place before the branch."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        Set<String> loose = PhaseChart.of(plan.plan(), plan.vocabulary()).branchesOfNothing().stream()
                .map(PhaseAction::id)
                .collect(Collectors.toSet());
        for (PlacedOutput output : plan.outputs()) {
            if (loose.contains(output.spec().id())) {
                report.accept(Finding.warning(
                        "W-PHASE-BRANCH",
                        output.pointer(),
                        words(plan.name(output)),
                        output.place().id(),
                        output.spec().id()));
            }
        }
        for (PlacedInput input : plan.inputs()) {
            if (loose.contains(input.spec().id())) {
                report.accept(Finding.warning(
                        "W-PHASE-BRANCH",
                        input.pointer(),
                        words(plan.name(input)),
                        input.transition().id(),
                        input.spec().id()));
            }
        }
    }

    private static String words(String event) {
        return event + " has the markup Phase Branch, but no event before it has Phase Item: "
                + "the phase chart has no action to put the branch on";
    }
}
