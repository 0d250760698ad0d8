package org.sami.spn.edit;

import java.util.Objects;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.TaskSpec;

/** Changes of the tasks of one plan. */
public sealed interface TaskEdit extends Edit {
    /** The id of the plan. */
    String plan();

    /** Adds a task at the end. */
    record AddTask(String plan, TaskSpec task) implements TaskEdit, PlanEdit {
        public AddTask {
            Objects.requireNonNull(plan, "plan");
            Objects.requireNonNull(task, "task");
        }

        @Override
        public String label() {
            return "Add task \"" + task.name() + "\"";
        }

        @Override
        public Plan change(Plan before, EditContext context) {
            return before.withTasks(Parts.with(before.tasks(), task));
        }
    }

    /** Gives the task of the same name another class or other fields. */
    record ChangeTask(String plan, TaskSpec task) implements TaskEdit, PlanEdit {
        public ChangeTask {
            Objects.requireNonNull(plan, "plan");
            Objects.requireNonNull(task, "task");
        }

        @Override
        public String label() {
            return "Change task \"" + task.name() + "\"";
        }

        @Override
        public Plan change(Plan before, EditContext context) throws EditRefusedException {
            check(before, task.name());
            return before.withTasks(Parts.replaced(before.tasks(), t -> t.name().equals(task.name()), t -> task));
        }
    }

    /** Removes a task; its remaining uses are reported. */
    record RemoveTask(String plan, String task) implements TaskEdit {
        public RemoveTask {
            Objects.requireNonNull(plan, "plan");
            Objects.requireNonNull(task, "task");
        }

        @Override
        public String label() {
            return "Remove task \"" + task + "\"";
        }

        @Override
        public Project change(Project project, EditContext context) throws EditRefusedException {
            check(Parts.plan(project, plan), task);
            new Usages(project)
                    .ofTask(plan, task).stream()
                            .filter(u -> !u.where().equals("declaration"))
                            .forEach(u -> context.tell("The plan \"" + u.plan() + "\" still speaks of the task " + task
                                    + ": " + (u.element().isEmpty() ? "" : u.element() + ", ") + u.where()));
            return project.withPlans(Parts.replaced(
                    project.plans(),
                    p -> p.id().equals(plan),
                    p -> p.withTasks(Parts.without(p.tasks(), t -> t.name().equals(task)))));
        }
    }

    /** Renames a task with all references: in requirements, in what parents and sub-missions give each other, in test cases. */
    record RenameTask(String plan, String from, String to) implements TaskEdit {
        public RenameTask {
            Objects.requireNonNull(plan, "plan");
            Objects.requireNonNull(from, "from");
            Objects.requireNonNull(to, "to");
        }

        @Override
        public String label() {
            return "Rename task \"" + from + "\" to \"" + to + "\"";
        }

        @Override
        public Project change(Project project, EditContext context) throws EditRefusedException {
            check(Parts.plan(project, plan), from);
            return project.withPlans(project.plans().stream()
                    .map(p -> PlanNames.replaced(p, this::renamed))
                    .toList());
        }

        private String renamed(NameUse use) {
            boolean meant = use.kind() == NameUse.Kind.TASK
                    && use.of().equals(plan)
                    && use.name().equals(from);
            return meant ? to : use.name();
        }
    }

    private static void check(Plan plan, String task) throws EditRefusedException {
        if (plan.tasks().stream().noneMatch(t -> t.name().equals(task))) {
            throw new EditRefusedException("The plan \"" + plan.id() + "\" has no task " + task);
        }
    }
}
