package org.sami.spn.edit;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import org.sami.spn.model.MissionTreeNode;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;

/** Finds where something of a project is used, in the order of the document. */
public final class Usages {
    private final Project project;

    /** The usages in a project. */
    public Usages(Project project) {
        this.project = Objects.requireNonNull(project, "project");
    }

    /**
     * Where a variable is declared, read, written, given to sub-missions or named.
     *
     * @param plan the plan that declares it; empty for one of the project
     */
    public List<Usage> ofVariable(Optional<String> plan, String variable) {
        VariableReach reach = new VariableReach(project, variable);
        Set<String> plans =
                plan.isPresent() ? project.plan(plan.get()).map(reach::below).orElse(Set.of()) : reach.ofProject();
        List<Usage> usages = new ArrayList<>();
        if (plan.isEmpty() && project.globals().stream().anyMatch(v -> v.name().equals(variable))) {
            usages.add(new Usage("", variable, "declaration"));
        }
        usages.addAll(
                find(u -> u.kind() == NameUse.Kind.VARIABLE && u.name().equals(variable) && plans.contains(u.of())));
        return usages;
    }

    /** Where a vertex, edge, event or sub-mission of a plan is spoken of: by edges, orders, the layout and test cases. */
    public List<Usage> ofElement(String plan, String id) {
        return find(u -> u.kind() == NameUse.Kind.ELEMENT
                && u.of().equals(plan)
                && u.name().equals(id)
                && !u.where().equals(NameUse.ITSELF));
    }

    /** Where a task of a plan is declared, asked for, given to or by a parent. */
    public List<Usage> ofTask(String plan, String task) {
        return find(u ->
                u.kind() == NameUse.Kind.TASK && u.of().equals(plan) && u.name().equals(task));
    }

    /** Where a plan is run, referred to, or shown in the mission tree. */
    public List<Usage> ofPlan(String plan) {
        List<Usage> usages = new ArrayList<>();
        tree(project.missionTree(), plan, usages);
        usages.addAll(find(u -> u.kind() == NameUse.Kind.PLAN && u.name().equals(plan)));
        return usages;
    }

    private static void tree(List<MissionTreeNode> nodes, String plan, List<Usage> usages) {
        for (MissionTreeNode node : nodes) {
            if (node.plan().equals(Optional.of(plan))) {
                usages.add(new Usage("", plan, "mission tree"));
            }
            tree(node.children(), plan, usages);
        }
    }

    /** Where events of a type stand, and occur in test cases. */
    public List<Usage> ofEventType(String type) {
        return find(u -> u.kind() == NameUse.Kind.EVENT_TYPE && u.name().equals(type));
    }

    /** Where an interrupt of a name is offered, taken, and pressed in test cases. */
    public List<Usage> ofInterrupt(String name) {
        return find(u -> u.kind() == NameUse.Kind.INTERRUPT && u.name().equals(name));
    }

    private List<Usage> find(Predicate<NameUse> which) {
        List<Usage> usages = new ArrayList<>();
        for (Plan plan : project.plans()) {
            PlanNames.forEach(plan, use -> {
                if (which.test(use)) {
                    usages.add(new Usage(plan.id(), use.element(), use.where()));
                }
            });
        }
        return usages;
    }
}
