package org.sami.spn.analysis;

import java.util.Set;
import java.util.function.Consumer;
import org.sami.spn.analysis.PlanContext.PlacedOutput;
import org.sami.spn.edit.RemoveElements;
import org.sami.spn.finding.Finding;
import org.sami.spn.vocabulary.EventFlag;

/** A command at an end place is sent, but nobody waits for it and it ends with the mission (R-END-3). */
final class CommandsAtTheEnd implements PlanCheck {
    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        for (PlacedOutput output : plan.outputs()) {
            if (output.place().end() && output.type().flags().contains(EventFlag.COMMAND)) {
                Finding finding = Finding.warning(
                        "W-COMMAND-AT-END",
                        output.pointer(),
                        plan.name(output) + " is sent as the mission ends: nobody waits for it",
                        output.place().id(),
                        output.spec().id());
                report.accept(
                        plan.outTransitions(output.place()).isEmpty()
                                        && output.spec().writes().isEmpty()
                                ? finding.fixedBy(
                                        "Remove the command",
                                        new RemoveElements(
                                                plan.plan().id(),
                                                Set.of(output.spec().id())))
                                : finding);
            }
        }
    }
}
