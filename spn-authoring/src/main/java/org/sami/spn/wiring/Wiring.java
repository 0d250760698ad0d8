package org.sami.spn.wiring;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.EditSequence;
import org.sami.spn.edit.FieldEdit;
import org.sami.spn.edit.VariableEdit;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.value.ValueType;

/** The edits that let a field be read from a source. */
public final class Wiring {
    private Wiring() {}

    /** Lets a field of an output event be read from a source; an answer that is not kept yet is written to a variable of its own. */
    public static Edit edit(Project project, Plan plan, String event, String field, ValueType type, DataSource source) {
        if (source instanceof DataSource.EnteringTask) {
            return new FieldEdit.SetField(plan.id(), event, field, new FieldSource.FromTask());
        }
        if (source instanceof DataSource.Variable variable) {
            return read(plan, event, field, variable.name());
        }
        DataSource.AnswerField answer = (DataSource.AnswerField) source;
        String variable = answer.variable().orElseGet(() -> freshName(project, plan, answer.field()));
        return answer.variable().isPresent()
                ? read(plan, event, field, variable)
                : new EditSequence(
                        "Read " + field + " of \"" + event + "\" from " + answer.type(),
                        List.of(
                                new VariableEdit.AddVariable(
                                        Optional.of(plan.id()), new VariableSpec(variable, type, Optional.empty())),
                                new FieldEdit.SetWrite(plan.id(), answer.event(), answer.field(), variable),
                                read(plan, event, field, variable)));
    }

    private static Edit read(Plan plan, String event, String field, String variable) {
        return new FieldEdit.SetField(plan.id(), event, field, new FieldSource.FromVariable(variable));
    }

    /** A name for a new variable of a plan, made of a field's. */
    public static String freshName(Project project, Plan plan, String field) {
        Set<String> taken = new HashSet<>(plan.reads());
        plan.variables().forEach(v -> taken.add(v.name()));
        project.globals().forEach(v -> taken.add(v.name()));
        plan.transitions()
                .forEach(t -> t.inputs().forEach(i -> taken.addAll(i.writes().values())));
        plan.places()
                .forEach(p -> p.outputs().forEach(o -> taken.addAll(o.writes().values())));
        String name = "@" + field;
        for (int n = 2; taken.contains(name); n++) {
            name = "@" + field + n;
        }
        return name;
    }
}
