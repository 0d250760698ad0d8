package org.sami.spn.analysis;

import java.util.List;
import java.util.function.Consumer;
import org.sami.spn.edit.VertexEdit;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.Transition;
import org.sami.spn.model.WaitFor;

/** A transition has an occasion to fire: an in place or an input event (R-LOOK-1). */
final class TransitionsThatNeverFire implements PlanCheck {
    @Override
    public List<Advice> advice() {
        return List.of(
                new Advice(
                        "W-NEVER-FIRES",
                        "Without a place before it or an input event nothing makes the transition fire.",
                        "Draw an edge from a place to it, or give it an input event."),
                new Advice(
                        "W-WAITS-FOR-NOTHING",
                        "It is to wait for all of its input events and has none: it fires without waiting for "
                                + "anything.",
                        "Give it the input events it is to wait for, or let it fire without waiting."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        for (Transition t : plan.plan().transitions()) {
            if (t.inputs().isEmpty() && plan.inEdges(t).isEmpty()) {
                report.accept(Finding.warning(
                        "W-NEVER-FIRES",
                        plan.at(t),
                        "The " + plan.name(t) + " has neither a place before it nor an input event: it never fires",
                        t.id()));
            }
            if (t.inputs().isEmpty() && t.waitFor() == WaitFor.ALL) {
                report.accept(Finding.warning(
                                "W-WAITS-FOR-NOTHING",
                                plan.at(t),
                                "The " + plan.name(t) + " waits for all, but has no input event to wait for",
                                t.id())
                        .fixedBy(
                                "Fire without waiting",
                                new VertexEdit.SetWaitFor(plan.plan().id(), t.id(), WaitFor.EACH)));
            }
        }
    }
}
