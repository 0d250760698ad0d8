package org.sami.spn.edit;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.SubMissionSpec;

/**
 * In which plans a name means one variable. A sub-mission sees its parents' variables under their names, unless it declares one of that
 * name itself or its parent gives it another (thesis 3.1).
 */
final class VariableReach {
    private final Project project;
    private final String name;
    private final Map<String, Set<String>> used = new HashMap<>();

    VariableReach(Project project, String name) {
        this.project = project;
        this.name = name;
        for (Plan plan : project.plans()) {
            PlanNames.forEach(plan, use -> {
                if (use.kind() == NameUse.Kind.VARIABLE && use.of().equals(plan.id())) {
                    used.computeIfAbsent(plan.id(), p -> new HashSet<>()).add(use.name());
                }
            });
        }
    }

    /** Whether a plan itself speaks of a variable of some name. */
    boolean uses(Plan plan, String variable) {
        return used.getOrDefault(plan.id(), Set.of()).contains(variable);
    }

    boolean declares(Plan plan) {
        return plan.variables().stream().anyMatch(v -> v.name().equals(name));
    }

    /** The ids of a plan and of those that it runs and that see its variable. */
    Set<String> below(Plan owner) {
        Set<String> reached = new LinkedHashSet<>();
        Deque<Plan> open = new ArrayDeque<>(List.of(owner));
        while (!open.isEmpty()) {
            Plan plan = open.pop();
            if (reached.add(plan.id())) {
                seeing(plan).forEach(open::push);
            }
        }
        return reached;
    }

    /** The plans that one runs and that see the name as it does. */
    private Stream<Plan> seeing(Plan plan) {
        return subMissions(plan)
                .filter(s -> !s.variables().containsKey(name))
                .flatMap(s -> project.plan(s.plan()).stream())
                .filter(child -> !declares(child));
    }

    /** The ids of the plans in which the name means the variable of the project: no plan that runs them has one of its own. */
    Set<String> ofProject() {
        Set<String> reached = new LinkedHashSet<>();
        project.plans().stream().filter(p -> !mappedByAll(p)).map(Plan::id).forEach(reached::add);
        project.plans().stream().filter(this::declares).forEach(p -> reached.removeAll(below(p)));
        return reached;
    }

    private boolean mappedByAll(Plan plan) {
        List<SubMissionSpec> runs = project.plans().stream()
                .flatMap(VariableReach::subMissions)
                .filter(s -> s.plan().equals(plan.id()))
                .toList();
        return !runs.isEmpty() && runs.stream().allMatch(s -> s.variables().containsKey(name));
    }

    /** Who declares the name as a plan sees it: a plan that runs it, else the project; empty where nobody does. */
    Optional<String> declaredAbove(Plan plan) {
        return project.plans().stream()
                .filter(p -> !p.id().equals(plan.id()) && declares(p) && below(p).contains(plan.id()))
                .map(p -> "the plan \"" + p.id() + "\"")
                .findFirst()
                .or(() -> project.globals().stream().anyMatch(v -> v.name().equals(name))
                        ? Optional.of("the project")
                        : Optional.empty());
    }

    /** Of the plans that see a variable those that others run as well, to which the name means something else. */
    Set<String> shared(Set<String> reached, String owner) {
        Set<String> shared = new LinkedHashSet<>();
        for (Plan plan : project.plans()) {
            if (!reached.contains(plan.id())) {
                subMissions(plan)
                        .filter(s -> !s.variables().containsKey(name))
                        .map(SubMissionSpec::plan)
                        .filter(child -> reached.contains(child) && !child.equals(owner))
                        .forEach(shared::add);
            }
        }
        return shared;
    }

    static Stream<SubMissionSpec> subMissions(Plan plan) {
        return plan.places().stream().flatMap(p -> p.subMissions().stream());
    }
}
