package org.sami.dreamm.inspector;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.profile.ProfileGuard;
import org.sami.palette.SemanticColor;
import org.sami.spn.edit.EventEdit;
import org.sami.spn.edit.RemoveElements;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.model.TaskSpec;
import org.sami.spn.model.VariableSpec;

/** One sub-mission of a place: its plan, static or dynamic, which tasks and variables it is given, and how it returns. */
final class SubMissionCard extends Form {
    private static final String NONE = "–";

    private final transient DreammContext context;
    private final transient Plan parent;
    private final transient SubMissionSpec spec;

    SubMissionCard(DreammContext context, Plan parent, SubMissionSpec spec, int index) {
        this.context = context;
        this.parent = parent;
        this.spec = spec;
        String name = "sub-mission-" + index;
        setName(name);
        heading("◎ Sub-mission");
        List<String> plans =
                context.document().project().plans().stream().map(Plan::id).toList();
        choice(
                "Runs",
                name + "-plan",
                "The plan that runs here",
                plans,
                Optional.of(spec.plan()),
                id -> context.document().plan(id).map(Plan::title).orElse(id),
                id -> change(new SubMissionSpec(spec.id(), id, spec.shared(), Map.of(), Map.of())));
        choice(
                "Instance",
                name + "-shared",
                "Dynamic: an instance for each visit. Static: one for the whole mission, which tokens join and leave",
                List.of(false, true),
                Optional.of(spec.shared()),
                shared -> shared ? "static: one, which all join" : "dynamic: one for each visit",
                shared -> change(new SubMissionSpec(spec.id(), spec.plan(), shared, spec.tasks(), spec.variables())));
        context.document().plan(spec.plan()).ifPresent(child -> mappings(name, child));
        wide(button(
                "Open plan",
                name + "-open",
                "Open the plan that runs here",
                () -> context.editor().open(spec.plan())));
        wide(button(
                "Delete",
                name + "-delete",
                "Delete the sub-mission",
                () -> context.apply(new RemoveElements(parent.id(), Set.of(spec.id())))));
    }

    private void change(SubMissionSpec changed) {
        context.apply(new EventEdit.ChangeSubMission(parent.id(), changed));
    }

    private void mappings(String name, Plan child) {
        List<String> childTasks = new ArrayList<>(List.of(NONE));
        child.tasks().stream().map(TaskSpec::name).forEach(childTasks::add);
        for (TaskSpec task : parent.tasks()) {
            ProfileGuard.mark(
                    choice(
                            task.name(),
                            name + "-task-" + task.name(),
                            "As which task of the child the parent's task starts",
                            childTasks,
                            Optional.of(spec.tasks().getOrDefault(task.name(), NONE)),
                            t -> t.equals(NONE) ? "not given" : "starts as " + t,
                            t -> change(spec.withTasks(mapped(spec.tasks(), task.name(), t)))),
                    "sub-mission-task");
        }
        Set<String> childVariables = new LinkedHashSet<>(child.reads());
        child.variables().stream().map(VariableSpec::name).forEach(childVariables::add);
        childVariables.addAll(spec.variables().keySet());
        List<String> own = new ArrayList<>(List.of(NONE));
        parent.variables().stream().map(VariableSpec::name).forEach(own::add);
        parent.reads().stream().filter(r -> !own.contains(r)).forEach(own::add);
        context.document().project().globals().stream()
                .map(VariableSpec::name)
                .filter(g -> !own.contains(g))
                .forEach(own::add);
        for (String variable : childVariables) {
            ProfileGuard.mark(
                    choice(
                            variable,
                            name + "-variable-" + variable.substring(1),
                            "Which variable of this plan stands for the child's " + variable,
                            own,
                            Optional.of(spec.variables().getOrDefault(variable, NONE)),
                            v -> v.equals(NONE) ? "by its own name" : "is " + v,
                            v -> change(spec.withVariables(mapped(spec.variables(), variable, v)))),
                    "sub-mission-variable");
        }
        List<String> ends = child.places().stream()
                .filter(Place::end)
                .map(p -> (p.name().isBlank() ? p.id() : p.name())
                        + (spec.shared()
                                ? p.endsSharedInstance() ? " (ends it for all)" : " (returns who enters)"
                                : ""))
                .toList();
        note(
                ends.isEmpty()
                        ? "▲ It never returns: the plan has no end place."
                        : "Returns at " + String.join(", ", ends) + ".",
                ends.isEmpty() ? SemanticColor.CRITICAL : SemanticColor.MUTED);
    }

    private static Map<String, String> mapped(Map<String, String> map, String key, String value) {
        Map<String, String> next = new LinkedHashMap<>(map);
        if (value.equals(NONE)) {
            next.remove(key);
        } else {
            next.put(key, value);
        }
        return next;
    }
}
