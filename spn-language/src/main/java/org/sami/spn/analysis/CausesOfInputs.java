package org.sami.spn.analysis;

import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import org.sami.spn.analysis.PlanContext.PlacedInput;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.vocabulary.EventFlag;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.EventType;

/**
 * An input event that answers has its cause on a place before its transition (thesis 4.3.3, Events), because an answer is
 * for a transition only where the place that asked is an in place of it (R-OCC-4). News have no cause;
 * interrupts, aborts and what sub-missions report come from elsewhere.
 */
final class CausesOfInputs implements PlanCheck {
    private static final Set<EventRole> FROM_ELSEWHERE = Set.of(
            EventRole.INTERRUPT,
            EventRole.ABORT_RECEIVED,
            EventRole.COMPLETE_RECEIVED,
            EventRole.SUB_MISSION_ABORTED,
            EventRole.CHECK_RETURN);

    @Override
    public List<Advice> advice() {
        return List.of(new Advice(
                "E-NO-CAUSE",
                "The answer never comes, as no place before the transition asks for it: the transition never "
                        + "fires.",
                "Put the output event that asks on a place before the transition, or wait for an answer to "
                        + "what is asked there."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        for (PlacedInput input : plan.inputs()) {
            List<EventType> causes = causes(plan, input.type());
            if (causes.isEmpty()
                    || input.type().flags().contains(EventFlag.NEWS)
                    || FROM_ELSEWHERE.contains(input.type().role())) {
                continue;
            }
            boolean before = plan.outputs().stream()
                    .filter(o -> causes.contains(o.type()))
                    .anyMatch(o -> plan.inPlaces(input.transition()).contains(o.place()));
            if (!before) {
                report.accept(Fixes.removing(
                        plan,
                        input,
                        Finding.error(
                                "E-NO-CAUSE",
                                input.pointer(),
                                "The " + plan.name(input.transition()) + " waits for "
                                        + input.type().title() + ", but no place before it has "
                                        + String.join(
                                                " or ",
                                                causes.stream()
                                                        .map(EventType::title)
                                                        .toList()),
                                input.transition().id(),
                                input.spec().id())));
            }
        }
    }

    private static List<EventType> causes(PlanContext plan, EventType input) {
        return plan.vocabulary().events().values().stream()
                .filter(e -> e.answers().contains(input.name()))
                .toList();
    }
}
