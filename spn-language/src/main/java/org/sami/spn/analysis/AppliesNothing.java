package org.sami.spn.analysis;

import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.sami.spn.analysis.PlanContext.PlacedOutput;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.FieldSource;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.Reserved;

/** What applies an allocation is given one: as a map from tasks to robots, or as a record that has one. */
final class AppliesNothing implements PlanCheck {
    @Override
    public List<Advice> advice() {
        return List.of(new Advice(
                "E-APPLIES-NOTHING",
                "No allocation reaches the robots, so none of them gets a task.",
                "Let the event read the allocation from the variable into which the answer before it writes."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        for (PlacedOutput output : plan.outputs()) {
            Map<String, FieldSource> fields = output.spec().fields();
            if (output.type().role() == EventRole.APPLY_ALLOCATION
                    && !fields.containsKey(Reserved.TASKS)
                    && !fields.containsKey(Reserved.ALLOCATION)) {
                report.accept(Finding.error(
                        "E-APPLIES-NOTHING",
                        output.pointer(),
                        plan.name(output) + " is given no allocation: read one that somebody chose from a variable",
                        output.place().id(),
                        output.spec().id()));
            }
        }
    }
}
