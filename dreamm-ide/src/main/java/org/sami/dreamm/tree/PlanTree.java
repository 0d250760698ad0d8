package org.sami.dreamm.tree;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.sami.dreamm.tree.TreeItem.Kind;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.EditSequence;
import org.sami.spn.edit.ProjectEdit;
import org.sami.spn.model.MissionTreeNode;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.model.TaskSpec;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.value.TypeNames;

/** The lines of the mission tree of a project, and the edits that move them. Plans that the project's own tree leaves out stand at the end. */
final class PlanTree {
    private PlanTree() {}

    /** The root, with all below it. */
    static TreeItem of(Project project) {
        List<TreeItem> children = new ArrayList<>();
        List<MissionTreeNode> nodes = whole(project);
        for (int i = 0; i < nodes.size(); i++) {
            children.add(item(project, nodes.get(i), List.of(i)));
        }
        if (!project.globals().isEmpty()) {
            children.add(new TreeItem(
                    Kind.VARIABLES,
                    "",
                    "",
                    "Variables of the project",
                    Integer.toString(project.globals().size()),
                    List.of(),
                    variables("", project.globals())));
        }
        String title = project.name().isEmpty() ? project.id() : project.name();
        return new TreeItem(Kind.PROJECT, "", "", title, count(project.plans().size()), List.of(), children);
    }

    private static String count(int plans) {
        return plans + (plans == 1 ? " plan" : " plans");
    }

    /** The project's mission tree with a leaf for each plan that it leaves out. */
    static List<MissionTreeNode> whole(Project project) {
        Set<String> shown = new HashSet<>();
        project.missionTree().forEach(node -> collect(node, shown));
        List<MissionTreeNode> whole = new ArrayList<>(project.missionTree());
        for (Plan plan : project.plans()) {
            if (!shown.contains(plan.id())) {
                whole.add(new MissionTreeNode("", Optional.of(plan.id()), List.of()));
            }
        }
        return whole;
    }

    private static void collect(MissionTreeNode node, Set<String> shown) {
        node.plan().ifPresent(shown::add);
        node.children().forEach(child -> collect(child, shown));
    }

    private static TreeItem item(Project project, MissionTreeNode node, List<Integer> path) {
        List<TreeItem> children = new ArrayList<>();
        for (int i = 0; i < node.children().size(); i++) {
            List<Integer> below = new ArrayList<>(path);
            below.add(i);
            children.add(item(project, node.children().get(i), below));
        }
        Optional<Plan> plan = node.plan().flatMap(project::plan);
        if (plan.isEmpty()) {
            return new TreeItem(Kind.FOLDER, node.plan().orElse(""), "", node.label(), "", path, children);
        }
        for (Place place : plan.get().places()) {
            place.subMissions().forEach(sub -> children.add(subMission(project, plan.get(), place, sub)));
        }
        plan.get().tasks().forEach(task -> children.add(task(plan.get(), task)));
        children.addAll(variables(plan.get().id(), plan.get().variables()));
        String name = name(plan.get());
        String id = name.equals(plan.get().id()) ? "" : plan.get().id();
        return new TreeItem(Kind.PLAN, plan.get().id(), "", name, id, path, children);
    }

    private static TreeItem subMission(Project project, Plan plan, Place place, SubMissionSpec sub) {
        String runs = project.plan(sub.plan()).map(PlanTree::name).orElse(sub.plan());
        String where = place.name().isEmpty() ? place.id() : place.name();
        String detail = (sub.shared() ? "static, at " : "at ") + where;
        return new TreeItem(Kind.SUB_MISSION, plan.id(), sub.id(), runs, detail, List.of(), List.of());
    }

    private static TreeItem task(Plan plan, TaskSpec task) {
        return new TreeItem(
                Kind.TASK, plan.id(), task.name(), task.name(), "task: " + task.taskClass(), List.of(), List.of());
    }

    private static List<TreeItem> variables(String plan, List<VariableSpec> variables) {
        return variables.stream()
                .map(v -> new TreeItem(
                        Kind.VARIABLE, plan, v.name(), v.name(), TypeNames.of(v.type()), List.of(), List.of()))
                .toList();
    }

    /** What people call a plan. */
    static String name(Plan plan) {
        return plan.name().isEmpty() ? plan.id() : plan.name();
    }

    /**
     * Moves a line. In a project without a tree of its own, moving a plan among plans changes their order and makes no tree.
     *
     * @param parent path of the line that it goes below; empty = the project
     * @param index among its new neighbours, after it was taken out
     */
    static Edit move(Project project, TreeItem moved, List<Integer> parent, int index) {
        if (project.missionTree().isEmpty() && parent.isEmpty() && moved.path().size() == 1) {
            return new ProjectEdit.MovePlan(moved.plan(), index);
        }
        return changed(
                project, "Move \"" + moved.title() + "\"", new ProjectEdit.MoveTreeNode(moved.path(), parent, index));
    }

    /** Adds a folder at the end. */
    static Edit addFolder(Project project, String label) {
        List<MissionTreeNode> nodes = new ArrayList<>(whole(project));
        nodes.add(new MissionTreeNode(label, Optional.empty(), List.of()));
        return new ProjectEdit.SetMissionTree(nodes);
    }

    /** Gives a folder another label. */
    static Edit labelFolder(Project project, TreeItem folder, String label) {
        return new ProjectEdit.SetMissionTree(replaced(
                whole(project),
                folder.path(),
                node -> List.of(new MissionTreeNode(label, node.plan(), node.children()))));
    }

    /** Removes a folder; what is in it takes its place. */
    static Edit removeFolder(Project project, TreeItem folder) {
        return new ProjectEdit.SetMissionTree(replaced(whole(project), folder.path(), MissionTreeNode::children));
    }

    private static Edit changed(Project project, String label, Edit edit) {
        List<MissionTreeNode> whole = whole(project);
        return whole.equals(project.missionTree())
                ? edit
                : new EditSequence(label, List.of(new ProjectEdit.SetMissionTree(whole), edit));
    }

    private static List<MissionTreeNode> replaced(
            List<MissionTreeNode> nodes,
            List<Integer> path,
            java.util.function.Function<MissionTreeNode, List<MissionTreeNode>> by) {
        List<MissionTreeNode> changed = new ArrayList<>();
        for (int i = 0; i < nodes.size(); i++) {
            MissionTreeNode node = nodes.get(i);
            if (i != path.get(0)) {
                changed.add(node);
            } else if (path.size() == 1) {
                changed.addAll(by.apply(node));
            } else {
                changed.add(node.withChildren(replaced(node.children(), path.subList(1, path.size()), by)));
            }
        }
        return changed;
    }
}
