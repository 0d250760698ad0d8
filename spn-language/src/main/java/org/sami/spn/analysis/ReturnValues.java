package org.sami.spn.analysis;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.sami.spn.analysis.PlanContext.PlacedInput;
import org.sami.spn.analysis.PlanContext.PlacedOutput;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.Plan;
import org.sami.spn.value.PlanReference;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.Reserved;

/** Who waits for a value that a sub-mission returns has one before it that can return it (appendix .2.2). */
final class ReturnValues implements PlanCheck {
    @Override
    public List<Advice> advice() {
        return List.of(new Advice(
                "W-NEVER-RETURNED",
                "The sub-mission never returns that value: the transition never fires.",
                "Correct the value, or let an end place of the sub-mission return it."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        for (PlacedInput input : plan.inputs()) {
            if (input.type().role() != EventRole.CHECK_RETURN) {
                continue;
            }
            List<Plan> children = plan.inPlaces(input.transition()).stream()
                    .flatMap(p -> p.subMissions().stream())
                    .map(plan::child)
                    .flatMap(Optional::stream)
                    .filter(child -> isChecked(input, child))
                    .toList();
            if (!children.isEmpty() || input.spec().fields().containsKey(Reserved.SUB_MISSION)) {
                checkValue(plan, input, children, report);
            }
        }
    }

    /** Whether it waits for returns of that plan: of the one that it names, else of any. */
    private static boolean isChecked(PlacedInput input, Plan child) {
        return !(input.spec().fields().get(Reserved.SUB_MISSION) instanceof PlanReference named)
                || named.plan().equals(child.id());
    }

    private static void checkValue(PlanContext plan, PlacedInput input, List<Plan> children, Consumer<Finding> report) {
        Value wanted = input.spec().fields().get(Reserved.VALUE);
        Set<Value> fixed = new HashSet<>();
        for (Plan child : children) {
            for (PlacedOutput output : plan.of(child).outputs()) {
                if (output.type().role() == EventRole.RETURN_VALUE) {
                    if (!(output.spec().fields().get(Reserved.VALUE) instanceof FieldSource.Fixed value)) {
                        return; // known only when it runs
                    }
                    fixed.add(value.value());
                }
            }
        }
        if (wanted != null && !fixed.contains(wanted)) {
            report.accept(Finding.warning(
                    "W-NEVER-RETURNED",
                    input.pointer(),
                    "The " + plan.name(input.transition()) + " waits for a value that no sub-mission before it returns",
                    input.transition().id(),
                    input.spec().id()));
        }
    }
}
