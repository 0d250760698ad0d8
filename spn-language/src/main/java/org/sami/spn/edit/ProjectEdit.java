package org.sami.spn.edit;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.sami.spn.model.MissionTreeNode;
import org.sami.spn.model.Note;
import org.sami.spn.model.Plan;
import org.sami.spn.model.PlanQuery;
import org.sami.spn.model.Project;
import org.sami.spn.model.TestCase;

/** Changes of the plans of a project as wholes, and of the tree in which they are shown. */
public sealed interface ProjectEdit extends Edit {
    /** Adds a plan at the end, and at the end of the mission tree where the project has one. */
    record AddPlan(Plan added) implements ProjectEdit {
        public AddPlan {
            Objects.requireNonNull(added, "added");
        }

        @Override
        public String label() {
            return "Add plan \"" + added.id() + "\"";
        }

        @Override
        public Project change(Project project, EditContext context) {
            Project grown = project.withPlans(Parts.with(project.plans(), added));
            return project.missionTree().isEmpty()
                    ? grown
                    : grown.withMissionTree(Parts.with(project.missionTree(), MissionTree.leaf(added.id())));
        }
    }

    /** Removes a plan. Sub-missions that run it are removed as well and reported; in the mission tree its children take its place. */
    record RemovePlan(String plan) implements ProjectEdit {
        public RemovePlan {
            Objects.requireNonNull(plan, "plan");
        }

        @Override
        public String label() {
            return "Delete plan \"" + plan + "\"";
        }

        @Override
        public Project change(Project project, EditContext context) throws EditRefusedException {
            Parts.plan(project, plan);
            for (Usage usage : new Usages(project).ofPlan(plan)) {
                if (!usage.plan().isEmpty() && !usage.plan().equals(plan)) {
                    String what = usage.where().equals("sub-mission")
                            ? " lost the sub-mission " + usage.element() + ", which ran \"" + plan + "\""
                            : " still names \"" + plan + "\": " + usage.element() + ", " + usage.where();
                    context.tell("The plan \"" + usage.plan() + "\"" + what);
                }
            }
            return project.withPlans(Parts.without(project.plans(), p -> p.id().equals(plan)).stream()
                            .map(p -> p.withPlaces(p.places().stream()
                                    .map(place -> place.withSubMissions(Parts.without(
                                            place.subMissions(), s -> s.plan().equals(plan))))
                                    .toList()))
                            .toList())
                    .withMissionTree(MissionTree.without(project.missionTree(), plan));
        }
    }

    /** Changes the id of a plan and all references to it. */
    record RenamePlan(String from, String to) implements ProjectEdit {
        public RenamePlan {
            Objects.requireNonNull(from, "from");
            Objects.requireNonNull(to, "to");
        }

        @Override
        public String label() {
            return "Rename plan \"" + from + "\" to \"" + to + "\"";
        }

        @Override
        public Project change(Project project, EditContext context) throws EditRefusedException {
            Parts.plan(project, from);
            if (!from.equals(to) && project.plan(to).isPresent()) {
                throw new EditRefusedException("The project has a plan \"" + to + "\" already");
            }
            List<Plan> plans = project.plans().stream()
                    .map(p -> PlanNames.replaced(p, this::renamed))
                    .map(p -> p.id().equals(from) ? p.withId(to) : p)
                    .toList();
            return project.withPlans(plans)
                    .withGlobals(project.globals().stream()
                            .map(v -> v.withInitial(
                                    v.initial().map(value -> new ValueNames("", this::renamed).value(value, "", ""))))
                            .toList())
                    .withMissionTree(MissionTree.renamed(project.missionTree(), from, to))
                    .withImportedFrom(project.importedFrom().map(o -> MissionTree.renamed(o, from, to)));
        }

        private String renamed(NameUse use) {
            return use.kind() == NameUse.Kind.PLAN && use.name().equals(from) ? to : use.name();
        }
    }

    /** Puts a copy of a plan behind it, in the list of plans and in the mission tree. */
    record ClonePlan(String plan, String id, String name) implements ProjectEdit {
        public ClonePlan {
            Objects.requireNonNull(plan, "plan");
            Objects.requireNonNull(id, "id");
            Objects.requireNonNull(name, "name");
        }

        @Override
        public String label() {
            return "Clone plan \"" + plan + "\"";
        }

        @Override
        public Project change(Project project, EditContext context) throws EditRefusedException {
            Plan copy = Parts.plan(project, plan).withId(id).withName(name);
            List<Plan> plans = new ArrayList<>();
            for (Plan p : project.plans()) {
                plans.add(p);
                if (p.id().equals(plan)) {
                    plans.add(copy);
                }
            }
            return project.withPlans(plans).withMissionTree(MissionTree.cloned(project.missionTree(), plan, id));
        }
    }

    /** Moves a plan to another index in the list of plans. */
    record MovePlan(String plan, int index) implements ProjectEdit {
        public MovePlan {
            Objects.requireNonNull(plan, "plan");
        }

        @Override
        public String label() {
            return "Move plan \"" + plan + "\"";
        }

        @Override
        public Project change(Project project, EditContext context) throws EditRefusedException {
            Parts.plan(project, plan);
            return project.withPlans(Parts.moved(project.plans(), Plan::id, plan, index));
        }
    }

    /** Sets the mission tree. */
    record SetMissionTree(List<MissionTreeNode> roots) implements ProjectEdit {
        public SetMissionTree {
            roots = List.copyOf(roots);
        }

        @Override
        public String label() {
            return "Change mission tree";
        }

        @Override
        public Project change(Project project, EditContext context) {
            return project.withMissionTree(roots);
        }
    }

    /**
     * Moves a node of the mission tree with its children.
     *
     * @param from the indices that lead to it from the roots
     * @param parent the indices that lead to its new parent, before the move; empty for the roots
     * @param index its index among its new neighbours, after it was taken out
     */
    record MoveTreeNode(List<Integer> from, List<Integer> parent, int index) implements ProjectEdit {
        public MoveTreeNode {
            from = List.copyOf(from);
            parent = List.copyOf(parent);
        }

        @Override
        public String label() {
            return "Move in mission tree";
        }

        @Override
        public Project change(Project project, EditContext context) throws EditRefusedException {
            return project.withMissionTree(MissionTree.moved(project.missionTree(), from, parent, index));
        }
    }

    /** Gives the project another name. */
    record NameProject(String name) implements ProjectEdit {
        public NameProject {
            Objects.requireNonNull(name, "name");
        }

        @Override
        public String label() {
            return "Name project";
        }

        @Override
        public Project change(Project project, EditContext context) {
            return project.withName(name);
        }
    }

    /** Sets what a plan says about itself. */
    record DescribePlan(String plan, String name, String description, List<Note> notes)
            implements ProjectEdit, PlanEdit {
        public DescribePlan {
            Objects.requireNonNull(plan, "plan");
            Objects.requireNonNull(name, "name");
            Objects.requireNonNull(description, "description");
            notes = List.copyOf(notes);
        }

        @Override
        public String label() {
            return "Describe plan \"" + plan + "\"";
        }

        @Override
        public Plan change(Plan before, EditContext context) {
            return before.withName(name).withDescription(description).withNotes(notes);
        }
    }

    /** Keeps a test case with a plan; one of the same name is replaced, and with an empty one removed. */
    record SetTestCase(String plan, String name, Optional<TestCase> testCase) implements ProjectEdit, PlanEdit {
        public SetTestCase {
            Objects.requireNonNull(plan, "plan");
            Objects.requireNonNull(name, "name");
            Objects.requireNonNull(testCase, "testCase");
        }

        @Override
        public String label() {
            return (testCase.isPresent() ? "Keep test case \"" : "Remove test case \"") + name + "\"";
        }

        @Override
        public Plan change(Plan before, EditContext context) {
            boolean there = before.testCases().stream().anyMatch(t -> t.name().equals(name));
            if (there && testCase.isPresent()) {
                return before.withTestCases(
                        Parts.replaced(before.testCases(), t -> t.name().equals(name), t -> testCase.get()));
            }
            List<TestCase> others =
                    Parts.without(before.testCases(), t -> t.name().equals(name));
            return before.withTestCases(testCase.map(t -> Parts.with(others, t)).orElse(others));
        }
    }

    /** Keeps a query with a plan; one of the same name is replaced, and with an empty one removed. */
    record SetQuery(String plan, String name, Optional<PlanQuery> query) implements ProjectEdit, PlanEdit {
        public SetQuery {
            Objects.requireNonNull(plan, "plan");
            Objects.requireNonNull(name, "name");
            Objects.requireNonNull(query, "query");
        }

        @Override
        public String label() {
            return (query.isPresent() ? "Keep query \"" : "Remove query \"") + name + "\"";
        }

        @Override
        public Plan change(Plan before, EditContext context) {
            boolean there = before.queries().stream().anyMatch(q -> q.name().equals(name));
            if (there && query.isPresent()) {
                return before.withQueries(
                        Parts.replaced(before.queries(), q -> q.name().equals(name), q -> query.get()));
            }
            List<PlanQuery> others =
                    Parts.without(before.queries(), q -> q.name().equals(name));
            return before.withQueries(query.map(q -> Parts.with(others, q)).orElse(others));
        }
    }
}
