package org.sami.dreamm.inspector;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.sami.dreamm.context.DreammContext;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.EditSequence;
import org.sami.spn.edit.VariableEdit;
import org.sami.spn.model.Plan;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.value.ValueType;

/** The variables that events of a plan can read and write: its own, those of the project, and those that it expects of its parents. */
record Scope(Plan plan, List<VariableSpec> globals) {
    static Scope of(DreammContext context, Plan plan) {
        return new Scope(plan, context.document().project().globals());
    }

    /** The names of those of a type; of what parents bring no type is known, so that they are always offered. */
    List<String> ofType(ValueType type) {
        List<String> names = new ArrayList<>();
        plan.variables().stream().filter(v -> v.type().equals(type)).forEach(v -> names.add(v.name()));
        globals.stream().filter(v -> v.type().equals(type)).forEach(v -> names.add(v.name()));
        plan.reads().stream().filter(name -> !declared(name)).forEach(names::add);
        return names.stream().distinct().toList();
    }

    private boolean declared(String name) {
        return plan.variables().stream().anyMatch(v -> v.name().equals(name))
                || globals.stream().anyMatch(v -> v.name().equals(name));
    }

    /** A name for a new variable, made of a field's. */
    String freshName(String field) {
        Set<String> taken = new HashSet<>(plan.reads());
        plan.variables().forEach(v -> taken.add(v.name()));
        globals.forEach(v -> taken.add(v.name()));
        String name = "@" + field;
        for (int n = 2; taken.contains(name); n++) {
            name = "@" + field + n;
        }
        return name;
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
