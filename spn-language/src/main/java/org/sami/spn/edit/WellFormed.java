package org.sami.spn.edit;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sami.spn.model.MissionTreeNode;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Whether a project could be written and read back: what the reader would refuse, in words for the author. What is well-formed may still
 * make no sense as a plan; that is found by the checks.
 */
final class WellFormed {
    private final Vocabulary vocabulary;

    WellFormed(Vocabulary vocabulary) {
        this.vocabulary = vocabulary;
    }

    /** What an edit would break. What was broken before stays the concern of others. */
    List<String> newProblems(Project before, Project after) {
        Set<String> known = new HashSet<>(ofProject(before));
        List<String> problems = new ArrayList<>(ofProject(after));
        Map<String, Plan> old = new HashMap<>();
        before.plans().forEach(p -> old.putIfAbsent(p.id(), p));
        Set<String> ids = ids(after);
        Set<String> oldIds = ids(before);
        for (Plan plan : after.plans()) {
            Plan was = old.get(plan.id());
            if (!sameForm(was, plan) || !ids.containsAll(oldIds)) {
                problems.addAll(ofPlan(plan, ids));
                if (was != null) {
                    known.addAll(ofPlan(was, oldIds));
                }
            }
        }
        problems.removeAll(known);
        return problems;
    }

    @SuppressWarnings("ReferenceEquality") // the same object is well-formed as it was
    private static boolean sameForm(@Nullable Plan was, Plan is) {
        return was == is;
    }

    private static Set<String> ids(Project project) {
        Set<String> ids = new HashSet<>();
        project.plans().forEach(p -> ids.add(p.id()));
        return ids;
    }

    private List<String> ofProject(Project project) {
        List<String> problems = new ArrayList<>();
        PlanForm.variables(project.globals(), "the project", vocabulary, problems);
        Set<String> ids = new HashSet<>();
        for (Plan plan : project.plans()) {
            if (plan.id().isEmpty()) {
                problems.add("A plan has an id that is not empty");
            } else if (!ids.add(plan.id())) {
                problems.add("The project has a plan \"" + plan.id() + "\" already");
            }
        }
        tree(project.missionTree(), ids, problems);
        return problems;
    }

    private static void tree(List<MissionTreeNode> nodes, Set<String> ids, List<String> problems) {
        for (MissionTreeNode node : nodes) {
            node.plan()
                    .filter(plan -> !ids.contains(plan))
                    .ifPresent(plan ->
                            problems.add("The mission tree shows the plan \"" + plan + "\", which is not there"));
            tree(node.children(), ids, problems);
        }
    }

    private List<String> ofPlan(Plan plan, Set<String> planIds) {
        return new PlanForm(plan, planIds, vocabulary).problems();
    }
}
