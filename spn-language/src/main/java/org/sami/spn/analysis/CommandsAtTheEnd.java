package org.sami.spn.analysis;

import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import org.sami.spn.analysis.PlanContext.PlacedOutput;
import org.sami.spn.edit.RemoveElements;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.vocabulary.EventFlag;

/** A command at an end place is sent, but nobody waits for it and it ends with the mission (R-END-3). */
final class CommandsAtTheEnd implements PlanCheck {
    @Override
    public List<Advice> advice() {
        return List.of(new Advice(
                "W-COMMAND-AT-END",
                "The mission is over as soon as the command is sent: nobody sees whether it was carried out.",
                "Put the command on a place before the end, with a transition that waits for its answer."));
    }

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
