package org.sami.spn.analysis;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import org.sami.spn.analysis.PlanContext.PlacedOutput;
import org.sami.spn.edit.EdgeEdit;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.EventEdit;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.finding.Suggestions;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.model.TaskSpec;
import org.sami.spn.model.TokenKind;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.Reserved;

/**
 * A requirement names a task of the plan or a class of tasks; a sub-mission is given tasks that both plans have; tasks are made of a
 * class that there is.
 */
final class NamedTasks implements PlanCheck {
    private static final String CODE = "E-UNKNOWN-TASK";

    @Override
    public List<Advice> advice() {
        return List.of(new Advice(
                CODE,
                "There is no task of that name or class: nobody can be given it.",
                "Correct the name, or add the task to the plan."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        for (InEdge e : plan.plan().inEdges()) {
            e.requirements().stream()
                    .filter(r -> r.kind() == TokenKind.TASK)
                    .forEach(r -> named(plan, r.task(), plan.at(e), e.id(), report, meant -> in(plan, e, r, meant)));
        }
        for (OutEdge e : plan.plan().outEdges()) {
            e.requirements().stream()
                    .filter(r -> r.kind() == TokenKind.TASK)
                    .forEach(r -> named(plan, r.task(), plan.at(e), e.id(), report, meant -> out(plan, e, r, meant)));
        }
        for (PlacedOutput output : plan.outputs()) {
            generated(plan, output, report);
        }
        for (Place place : plan.plan().places()) {
            for (int i = 0; i < place.subMissions().size(); i++) {
                mapped(plan, place.subMissions().get(i), plan.at(place) + "/subMissions/" + i, report);
            }
        }
    }

    private static void named(
            PlanContext plan,
            String task,
            String pointer,
            String edge,
            Consumer<Finding> report,
            Function<String, Edit> fix) {
        if (!has(plan.plan(), task) && !plan.vocabulary().taskClasses().containsKey(task)) {
            List<String> known = new ArrayList<>(
                    plan.plan().tasks().stream().map(TaskSpec::name).toList());
            known.addAll(plan.vocabulary().taskClasses().keySet());
            Finding finding = Finding.error(
                    CODE,
                    pointer,
                    "\"" + task + "\" is neither a task of this plan nor a class of tasks"
                            + Suggestions.meant(known, task),
                    edge);
            report.accept(Fixes.meant(finding, Suggestions.alike(known, task), fix));
        }
    }

    private static void generated(PlanContext plan, PlacedOutput output, Consumer<Finding> report) {
        FieldSource source = output.spec().fields().get(Reserved.TASK_CLASS);
        Optional<Value> given = source instanceof FieldSource.Fixed fixed
                ? Optional.of(fixed.value())
                : source instanceof FieldSource.Asked asked ? asked.defaultValue() : Optional.empty();
        if (output.type().role() == EventRole.GENERATE_TASKS
                && given.isPresent()
                && given.get() instanceof TextValue text
                && !plan.vocabulary().taskClasses().containsKey(text.value())) {
            report.accept(Finding.error(
                    CODE,
                    output.pointer() + "/fields/" + Reserved.TASK_CLASS,
                    "There is no class of tasks \"" + text.value() + "\"; there are "
                            + String.join(", ", plan.vocabulary().taskClasses().keySet()),
                    output.spec().id()));
        }
    }

    private static void mapped(PlanContext plan, SubMissionSpec s, String pointer, Consumer<Finding> report) {
        Optional<Plan> child = plan.child(s);
        s.tasks().forEach((parentTask, childTask) -> {
            if (!has(plan.plan(), parentTask)) {
                report.accept(Finding.error(
                                CODE,
                                pointer,
                                "The sub-mission \"" + plan.title(s) + "\" is given the task \"" + parentTask
                                        + "\", which this plan does not have",
                                s.id())
                        .fixedBy("Do not give the task " + parentTask, withoutTask(plan, s, parentTask)));
            }
            if (child.isPresent() && !has(child.get(), childTask)) {
                report.accept(Finding.error(
                                CODE,
                                pointer,
                                "The sub-mission \"" + plan.title(s) + "\" has no task \"" + childTask
                                        + "\" to be given",
                                s.id())
                        .fixedBy("Do not give the task " + parentTask, withoutTask(plan, s, parentTask)));
            }
        });
    }

    private static boolean has(Plan plan, String task) {
        return plan.tasks().stream().anyMatch(t -> t.name().equals(task));
    }

    private static Edit in(PlanContext plan, InEdge e, InRequirement r, String task) {
        return new EdgeEdit.SetInRequirements(
                plan.plan().id(),
                e.id(),
                e.requirements().stream()
                        .map(o -> o.equals(r) ? new InRequirement(r.kind(), r.match(), r.n(), task) : o)
                        .toList());
    }

    private static Edit out(PlanContext plan, OutEdge e, OutRequirement r, String task) {
        return new EdgeEdit.SetOutRequirements(
                plan.plan().id(),
                e.id(),
                e.requirements().stream()
                        .map(o -> o.equals(r) ? new OutRequirement(r.kind(), r.n(), r.action(), task) : o)
                        .toList());
    }

    private static Edit withoutTask(PlanContext plan, SubMissionSpec s, String task) {
        Map<String, String> tasks = new LinkedHashMap<>(s.tasks());
        tasks.remove(task);
        return new EventEdit.ChangeSubMission(plan.plan().id(), s.withTasks(tasks));
    }
}
