package org.sami.spn.analysis;

import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import org.sami.spn.analysis.PlanContext.PlacedInput;
import org.sami.spn.analysis.PlanContext.PlacedOutput;
import org.sami.spn.finding.Finding;
import org.sami.spn.vocabulary.EventFlag;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.EventType;

/**
 * An input event that answers has its cause on a place before its transition (thesis 4.3.3, Events). News have no cause;
 * interrupts, aborts and what sub-missions report come from elsewhere. Differs from 4.3.3 in one point: as a robot goes on
 * with a command when it leaves the place, the cause may be a command on another place; that is a warning.
 */
final class CausesOfInputs implements PlanCheck {
    private static final Set<EventRole> FROM_ELSEWHERE = Set.of(
            EventRole.INTERRUPT,
            EventRole.ABORT_RECEIVED,
            EventRole.COMPLETE_RECEIVED,
            EventRole.SUB_MISSION_ABORTED,
            EventRole.CHECK_RETURN);

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        for (PlacedInput input : plan.inputs()) {
            List<EventType> causes = causes(plan, input.type());
            if (causes.isEmpty() || FROM_ELSEWHERE.contains(input.type().role())) {
                continue;
            }
            List<PlacedOutput> asking = plan.outputs().stream()
                    .filter(o -> causes.contains(o.type()))
                    .toList();
            boolean before = asking.stream()
                    .anyMatch(o -> plan.inPlaces(input.transition()).contains(o.place()));
            if (before) {
                continue;
            }
            boolean commandElsewhere =
                    asking.stream().anyMatch(o -> o.type().flags().contains(EventFlag.COMMAND));
            String names =
                    String.join(" or ", causes.stream().map(EventType::name).toList());
            String message = "The " + PlanContext.name(input.transition()) + " waits for "
                    + input.type().name() + ", but no place before it has " + names;
            report.accept(
                    commandElsewhere
                            ? Finding.warning(
                                    "W-CAUSE-ELSEWHERE",
                                    input.pointer(),
                                    message + "; only one elsewhere has",
                                    input.transition().id(),
                                    input.spec().id())
                            : Finding.error(
                                    "E-NO-CAUSE",
                                    input.pointer(),
                                    message,
                                    input.transition().id(),
                                    input.spec().id()));
        }
    }

    private static List<EventType> causes(PlanContext plan, EventType input) {
        return plan.vocabulary().events().values().stream()
                .filter(e -> e.answers().contains(input.name()))
                .toList();
    }
}
