package org.sami.spn.analysis;

import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import org.sami.spn.analysis.PlanContext.PlacedInput;
import org.sami.spn.analysis.PlanContext.PlacedOutput;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.FieldType;

/** Every field that an event needs has a source (thesis 3.1, Events). */
final class RequiredFields implements PlanCheck {
    /** Input events whose fields say what they wait for; the fields of the others are filled by what arrives. */
    private static final Set<EventRole> SELECTED_BY_FIELDS = Set.of(EventRole.INTERRUPT, EventRole.CHECK_RETURN);

    @Override
    public List<Advice> advice() {
        return List.of(new Advice(
                "E-FIELD-MISSING",
                "The event cannot be carried out without the field.",
                "Give the field a value, a variable, a field of the task, or ask the operator for it."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        for (PlacedOutput output : plan.outputs()) {
            for (FieldType field : output.type().fields()) {
                if (field.required() && !output.spec().fields().containsKey(field.name())) {
                    report.accept(Fixes.asking(
                            plan,
                            output.spec().id(),
                            field.name(),
                            Finding.error(
                                    "E-FIELD-MISSING",
                                    output.pointer(),
                                    plan.name(output) + " lacks its field " + field.name(),
                                    output.place().id(),
                                    output.spec().id())));
                }
            }
        }
        for (PlacedInput input : plan.inputs()) {
            for (FieldType field : input.type().fields()) {
                if (field.required()
                        && SELECTED_BY_FIELDS.contains(input.type().role())
                        && !input.spec().fields().containsKey(field.name())) {
                    report.accept(Finding.error(
                            "E-FIELD-MISSING",
                            input.pointer(),
                            plan.name(input) + " lacks its field " + field.name(),
                            input.transition().id(),
                            input.spec().id()));
                }
            }
        }
    }
}
