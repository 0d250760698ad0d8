package org.sami.spn.analysis;

import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.function.Consumer;
import org.sami.spn.analysis.PlanContext.PlacedOutput;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.vocabulary.EventRole;

/** Somebody does what an output event asks: the operator, the engine itself, or a handler of the program that checks. */
final class HandledOutputs implements PlanCheck {
    private final Set<String> handled;

    HandledOutputs(Set<String> handled) {
        this.handled = Set.copyOf(Objects.requireNonNull(handled, "handled"));
    }

    @Override
    public List<Advice> advice() {
        return List.of(new Advice(
                "W-NO-HANDLER",
                "Nothing carries the event out and nothing answers: the mission hangs at the place.",
                "Use an event that the program handles, or run the plan in a program that handles this one."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        for (PlacedOutput output : plan.outputs()) {
            if (output.type().role() == EventRole.NONE
                    && output.type().decision().isEmpty()
                    && !handled.contains(output.type().name())) {
                report.accept(Finding.warning(
                        "W-NO-HANDLER",
                        output.pointer(),
                        "Nothing in this program handles " + plan.name(output)
                                + ": nothing will happen, and nothing answers",
                        output.place().id(),
                        output.spec().id()));
            }
        }
    }
}
