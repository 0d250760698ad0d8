package org.sami.dreamm.inspector;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.dreamm.context.DreammContext;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.EditSequence;
import org.sami.spn.edit.VariableEdit;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.wiring.DataSource;
import org.sami.spn.wiring.ReachingData;
import org.sami.spn.wiring.Wiring;

/** The data that events of a plan can read and write: variables of the plan, of the project and of its parents, and answers. */
record Scope(Project project, Plan plan, ReachingData data) {
    static Scope of(DreammContext context, Plan plan) {
        Project project = context.document().project();
        return new Scope(project, plan, new ReachingData(project, plan, context.vocabulary()));
    }

    /** The names of those of a type; of what parents bring no type is known, so that they are always offered. */
    List<String> ofType(ValueType type) {
        List<String> names = new ArrayList<>();
        plan.variables().stream().filter(v -> v.type().equals(type)).forEach(v -> names.add(v.name()));
        project.globals().stream().filter(v -> v.type().equals(type)).forEach(v -> names.add(v.name()));
        plan.reads().stream().filter(name -> !declared(name)).forEach(names::add);
        return names.stream().distinct().toList();
    }

    private boolean declared(String name) {
        return plan.variables().stream().anyMatch(v -> v.name().equals(name))
                || project.globals().stream().anyMatch(v -> v.name().equals(name));
    }

    /** What a field of an output event can be read from, nearest first. */
    List<DataSource> sources(String event, FieldType field) {
        return plan.places().stream()
                .filter(p -> p.outputs().stream().anyMatch(o -> o.id().equals(event)))
                .findFirst()
                .map(p -> data.of(p.id(), field))
                .orElse(List.of());
    }

    /** The edit that lets a field be read from a source. */
    Edit reading(String event, FieldType field, DataSource source) {
        return Wiring.edit(project, plan, event, field.name(), field.type(), source);
    }

    /** A name for a new variable, made of a field's. */
    String freshName(String field) {
        return Wiring.freshName(project, plan, field);
    }

    /** Declares a variable of the plan and does something with it, as one. */
    Edit declaring(String name, ValueType type, Edit use) {
        return new EditSequence(
                "Declare " + name + " and use it",
                List.of(
                        new VariableEdit.AddVariable(
                                Optional.of(plan.id()), new VariableSpec(name, type, Optional.empty())),
                        use));
    }
}
