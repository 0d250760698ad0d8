package org.sami.dreamm.inspector;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javax.swing.JComboBox;
import javax.swing.JPanel;
import javax.swing.JTextField;
import net.miginfocom.swing.MigLayout;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.profile.ProfileGuard;
import org.sami.palette.SemanticColor;
import org.sami.spn.edit.ProjectEdit;
import org.sami.spn.edit.RenameVariable;
import org.sami.spn.edit.TaskEdit;
import org.sami.spn.edit.Usage;
import org.sami.spn.edit.Usages;
import org.sami.spn.edit.VariableEdit;
import org.sami.spn.model.Plan;
import org.sami.spn.model.TaskSpec;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.naming.ElementNames;
import org.sami.spn.value.TypeNames;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.TaskClass;
import org.sami.ui.value.ValueField;

/** The plan itself, where nothing is selected: its name, its tasks, the variables of each scope with their uses. */
final class PlanSection extends Form {
    private static final String NO_TYPE = "+ Variable of type…";
    private static final String NO_CLASS = "+ Task of class…";
    private static final int MOST_USES = 4;

    private final transient DreammContext context;
    private final transient Plan plan;

    PlanSection(DreammContext context, Plan plan) {
        this.context = context;
        this.plan = plan;
        setName("inspector-plan");
        text(
                "Name",
                "plan-name",
                "What people call the plan; its id in the file is " + plan.id(),
                plan.name(),
                n -> context.apply(new ProjectEdit.DescribePlan(plan.id(), n, plan.description(), plan.notes())));
        text(
                "About",
                "plan-description",
                "A few sentences for those who choose a plan",
                plan.description(),
                d -> context.apply(new ProjectEdit.DescribePlan(plan.id(), plan.name(), d, plan.notes())));
        Form tasks = section("plan-tasks", "Tasks");
        plan.tasks().forEach(task -> task(tasks, task));
        addTask(tasks);
        Form variables = section("plan-variables", "Variables of the plan");
        variables(variables, Optional.of(plan.id()), plan.variables());
        if (!plan.reads().isEmpty()) {
            variables.note("Expected of parents: " + String.join(", ", plan.reads()), SemanticColor.MUTED);
        }
        variables(
                section("project-variables", "Variables of the project"),
                Optional.empty(),
                context.document().project().globals());
    }

    private void task(Form tasks, TaskSpec task) {
        JPanel row = line();
        JTextField name = new JTextField(task.name());
        name.setName("task-" + task.name());
        ProfileGuard.mark(name, "plan-task");
        name.setToolTipText("Name of the task; renamed everywhere it is used");
        giveWhenLeft(name, task.name(), n -> context.apply(new TaskEdit.RenameTask(plan.id(), task.name(), n)));
        row.add(name, "growx, pushx, wmin 0");
        row.add(new javax.swing.JLabel(task.taskClass()));
        row.add(ProfileGuard.mark(
                button(
                        "×",
                        "task-remove-" + task.name(),
                        "Delete the task " + task.name(),
                        () -> context.apply(new TaskEdit.RemoveTask(plan.id(), task.name()))),
                "plan-task-remove"));
        tasks.wide(row);
        TaskClass of = context.vocabulary().taskClasses().get(task.taskClass());
        if (of != null) {
            for (FieldType field : of.fields()) {
                ValueField shown = ValueField.of(field);
                tasks.wide(new javax.swing.JLabel(shown.label()));
                tasks.wide(ProfileGuard.mark(value(task, field, shown), "plan-task-value"));
            }
        }
    }

    private ValueRow value(TaskSpec task, FieldType field, ValueField shown) {
        ValueField of = new ValueField(
                task.name() + "." + field.name(), shown.label(), shown.type(), shown.unit(), shown.help());
        return new ValueRow(
                context.values().editor(of), Optional.ofNullable(task.fields().get(field.name())), v -> {
                    Map<String, org.sami.spn.value.Value> fields = new java.util.LinkedHashMap<>(task.fields());
                    fields.put(field.name(), v);
                    context.apply(new TaskEdit.ChangeTask(plan.id(), task.withFields(fields)));
                });
    }

    private void addTask(Form tasks) {
        JComboBox<String> add = new JComboBox<>();
        add.addItem(NO_CLASS);
        context.vocabulary().taskClasses().keySet().forEach(add::addItem);
        add.setName("plan-add-task");
        add.addActionListener(e -> {
            if (add.getSelectedIndex() > 0) {
                String of = (String) add.getSelectedItem();
                context.apply(new TaskEdit.AddTask(
                        plan.id(), new TaskSpec(of + " " + (plan.tasks().size() + 1), of, Map.of())));
            }
        });
        tasks.wide(add);
    }

    private static JPanel line() {
        JPanel row = new JPanel(new MigLayout("novisualpadding, insets 0, gap 4, fillx"));
        row.setOpaque(false);
        return row;
    }

    private void variables(Form section, Optional<String> owner, List<VariableSpec> variables) {
        String prefix = owner.isPresent() ? "variable-" : "global-";
        String of = owner.isPresent() ? "plan-" : "project-";
        for (VariableSpec v : variables) {
            JPanel row = line();
            JTextField name = new JTextField(v.name());
            name.setName(prefix + v.name().substring(1));
            ProfileGuard.mark(name, of + "variable");
            name.setToolTipText("Name of the variable; renamed everywhere it is used. Type " + TypeNames.of(v.type()));
            giveWhenLeft(name, v.name(), n -> context.apply(new RenameVariable(owner, v.name(), n)));
            row.add(name, "growx, pushx, wmin 0");
            row.add(new javax.swing.JLabel(TypeNames.of(v.type())), "wmin 0");
            row.add(ProfileGuard.mark(
                    button(
                            "×",
                            prefix + "remove-" + v.name().substring(1),
                            "Delete the variable " + v.name(),
                            () -> context.apply(new VariableEdit.RemoveVariable(owner, v.name()))),
                    of + "variable-remove"));
            section.wide(row);
            section.note(uses(owner, v), SemanticColor.MUTED);
        }
        JComboBox<String> add = new JComboBox<>();
        add.addItem(NO_TYPE);
        types().forEach(t -> add.addItem(TypeNames.of(t)));
        add.setName(prefix + "add");
        ProfileGuard.mark(add, of + "add-variable");
        add.addActionListener(e -> {
            if (add.getSelectedIndex() > 0) {
                ValueType type = types().get(add.getSelectedIndex() - 1);
                String name = Scope.of(context, plan).freshName("new");
                context.apply(new VariableEdit.AddVariable(owner, new VariableSpec(name, type, Optional.empty())));
            }
        });
        section.wide(add);
    }

    private String uses(Optional<String> owner, VariableSpec v) {
        List<Usage> uses = new Usages(context.document().project())
                .ofVariable(owner, v.name()).stream()
                        .filter(u -> !u.where().equals("declaration"))
                        .toList();
        if (uses.isEmpty()) {
            return "Not used.";
        }
        List<String> words =
                new ArrayList<>(uses.stream().limit(MOST_USES).map(this::words).toList());
        if (uses.size() > MOST_USES) {
            words.add("and " + (uses.size() - MOST_USES) + " more");
        }
        return "Used: " + String.join("; ", words);
    }

    private String words(Usage use) {
        Optional<Plan> in = context.document().plan(use.plan());
        String element = in.flatMap(p -> new ElementNames(p, context.vocabulary()).of(use.element()))
                .map(name -> name + ", ")
                .orElse("");
        String other = in.filter(p -> !p.id().equals(plan.id()))
                .map(p -> p.title() + ": ")
                .orElse("");
        return other + element + use.where();
    }

    private List<ValueType> types() {
        List<ValueType> types = new ArrayList<>();
        for (ValueType.Simple simple : ValueType.Simple.values()) {
            types.add(simple);
        }
        context.vocabulary().events().values().stream()
                .flatMap(e -> e.fields().stream())
                .map(FieldType::type)
                .filter(t -> !types.contains(t))
                .distinct()
                .forEach(types::add);
        return types;
    }
}
