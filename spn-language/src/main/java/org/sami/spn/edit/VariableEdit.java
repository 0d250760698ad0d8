package org.sami.spn.edit;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.VariableSpec;

/** Changes of declared variables: of one plan, or of the project where no plan is named. */
public sealed interface VariableEdit extends Edit {
    /** The id of the plan that declares the variable; empty for one of the project. */
    Optional<String> plan();

    /** Changes the variables that are declared there. */
    List<VariableSpec> changeDeclared(List<VariableSpec> declared, String where) throws EditRefusedException;

    @Override
    default Project change(Project project, EditContext context) throws EditRefusedException {
        if (plan().isEmpty()) {
            return project.withGlobals(changeDeclared(project.globals(), "The project"));
        }
        Plan before = Parts.plan(project, plan().get());
        List<VariableSpec> changed = changeDeclared(before.variables(), "The plan \"" + before.id() + "\"");
        return project.withPlans(
                Parts.replaced(project.plans(), p -> p.id().equals(before.id()), p -> p.withVariables(changed)));
    }

    /** Declares a variable. */
    record AddVariable(Optional<String> plan, VariableSpec variable) implements VariableEdit {
        public AddVariable {
            Objects.requireNonNull(plan, "plan");
            Objects.requireNonNull(variable, "variable");
        }

        @Override
        public String label() {
            return "Declare " + variable.name();
        }

        @Override
        public List<VariableSpec> changeDeclared(List<VariableSpec> declared, String where) {
            return Parts.with(declared, variable);
        }
    }

    /** Gives the variable of the same name another type or first value. */
    record ChangeVariable(Optional<String> plan, VariableSpec variable) implements VariableEdit {
        public ChangeVariable {
            Objects.requireNonNull(plan, "plan");
            Objects.requireNonNull(variable, "variable");
        }

        @Override
        public String label() {
            return "Change " + variable.name();
        }

        @Override
        public List<VariableSpec> changeDeclared(List<VariableSpec> declared, String where)
                throws EditRefusedException {
            check(declared, variable.name(), where);
            return Parts.replaced(declared, v -> v.name().equals(variable.name()), v -> variable);
        }
    }

    /** Removes a declaration; remaining uses of the variable are reported. */
    record RemoveVariable(Optional<String> plan, String variable) implements VariableEdit {
        public RemoveVariable {
            Objects.requireNonNull(plan, "plan");
            Objects.requireNonNull(variable, "variable");
        }

        @Override
        public String label() {
            return "Remove " + variable;
        }

        @Override
        public List<VariableSpec> changeDeclared(List<VariableSpec> declared, String where)
                throws EditRefusedException {
            check(declared, variable, where);
            return Parts.without(declared, v -> v.name().equals(variable));
        }

        @Override
        public Project change(Project project, EditContext context) throws EditRefusedException {
            new Usages(project)
                    .ofVariable(plan, variable).stream()
                            .filter(u -> !u.where().equals("declaration"))
                            .forEach(u -> context.tell("The plan \"" + u.plan() + "\" still speaks of " + variable
                                    + ": " + (u.element().isEmpty() ? "" : u.element() + ", ") + u.where()));
            return VariableEdit.super.change(project, context);
        }
    }

    private static void check(List<VariableSpec> declared, String name, String where) throws EditRefusedException {
        if (declared.stream().noneMatch(v -> v.name().equals(name))) {
            throw new EditRefusedException(where + " declares no variable " + name);
        }
    }
}
