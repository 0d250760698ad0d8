package org.sami.spn.analysis;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.sami.spn.analysis.PlanContext.PlacedInput;
import org.sami.spn.analysis.PlanContext.PlacedOutput;
import org.sami.spn.edit.FieldEdit;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.finding.Suggestions;
import org.sami.spn.model.FieldSource;
import org.sami.spn.value.TypeCheck;
import org.sami.spn.value.TypeNames;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.Direction;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.FieldType;

/** Values that stand in a plan are of their field's type, and the fields exist. */
final class FieldValues implements PlanCheck {
    @Override
    public List<Advice> advice() {
        return List.of(
                new Advice(
                        "E-FIELD-TYPE",
                        "The handler of the event cannot read the value.",
                        "Write a value of the type that the field has."),
                new Advice(
                        "E-UNKNOWN-FIELD",
                        "The event has no such field: the value reaches nobody.",
                        "Correct the name of the field, or delete it."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        for (PlacedOutput output : plan.outputs()) {
            output.spec()
                    .fields()
                    .forEach((name, source) -> check(
                            plan,
                            output.type(),
                            name,
                            value(source),
                            output.pointer(),
                            output.spec().id(),
                            report));
        }
        for (PlacedInput input : plan.inputs()) {
            for (Map.Entry<String, Value> e : input.spec().fields().entrySet()) {
                check(
                        plan,
                        input.type(),
                        e.getKey(),
                        Optional.of(e.getValue()),
                        input.pointer(),
                        input.spec().id(),
                        report);
            }
        }
    }

    private static Optional<Value> value(FieldSource source) {
        if (source instanceof FieldSource.Fixed fixed) {
            return Optional.of(fixed.value());
        }
        return source instanceof FieldSource.Asked asked ? asked.defaultValue() : Optional.empty();
    }

    private static void check(
            PlanContext plan,
            EventType type,
            String name,
            Optional<Value> value,
            String pointer,
            String id,
            Consumer<Finding> report) {
        Optional<FieldType> field = type.field(name);
        if (field.isEmpty()) {
            report.accept(Finding.error(
                            "E-UNKNOWN-FIELD",
                            pointer + "/fields/" + name,
                            type.name() + " has no field \"" + name + "\""
                                    + Suggestions.meant(
                                            type.fields().stream()
                                                    .map(FieldType::name)
                                                    .toList(),
                                            name),
                            id)
                    .fixedBy(
                            "Remove the field " + name,
                            new FieldEdit.ClearField(plan.plan().id(), id, name)));
        } else if (value.isPresent()
                && !TypeCheck.accepts(
                        field.get().type(), value.get(), plan.vocabulary().types())) {
            Finding finding = Finding.error(
                    "E-FIELD-TYPE",
                    pointer + "/fields/" + name,
                    "The value of " + name + " in " + type.name() + " is not of its type "
                            + TypeNames.of(field.get().type()),
                    id);
            report.accept(
                    type.direction() == Direction.OUTPUT
                            ? Fixes.asking(plan, id, name, finding)
                            : finding.fixedBy(
                                    "Remove the value of " + name,
                                    new FieldEdit.ClearField(plan.plan().id(), id, name)));
        }
    }
}
