package org.sami.spn.analysis;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.sami.spn.analysis.PlanContext.PlacedOutput;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.FieldSource;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.FieldType;

/** {@code @task} reads a field of the entering tasks: some class of tasks has that field, of that type (thesis 9.3.4). */
final class TaskFields implements PlanCheck {
    @Override
    public List<Advice> advice() {
        return List.of(new Advice(
                "E-TASK-FIELD",
                "No task has a field of that name and type: the event gets no value.",
                "Choose a field that a class of tasks has, or add it to the class."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        for (PlacedOutput output : plan.outputs()) {
            output.spec().fields().forEach((name, source) -> {
                Optional<ValueType> type = output.type().field(name).map(FieldType::type);
                if (source instanceof FieldSource.FromTask && type.isPresent() && !offered(plan, name, type.get())) {
                    report.accept(Fixes.asking(
                            plan,
                            output.spec().id(),
                            name,
                            Finding.error(
                                    "E-TASK-FIELD",
                                    output.pointer() + "/fields/" + name,
                                    plan.name(output)
                                            + " reads the field " + name
                                            + " from a task, but no class of tasks has it with that type",
                                    output.place().id(),
                                    output.spec().id())));
                }
            });
        }
    }

    private static boolean offered(PlanContext plan, String name, ValueType type) {
        return plan.vocabulary().taskClasses().values().stream()
                .flatMap(c -> c.fields().stream())
                .anyMatch(f -> f.name().equals(name) && f.type().equals(type));
    }
}
