package org.sami.dreamm.tree;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Function;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.EditSequence;
import org.sami.spn.edit.ProjectEdit;
import org.sami.spn.edit.RenameElement;
import org.sami.spn.edit.RenameInterrupt;
import org.sami.spn.edit.RenameVariable;
import org.sami.spn.edit.TaskEdit;
import org.sami.spn.edit.Usages;
import org.sami.spn.edit.VertexEdit;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.Transition;
import org.sami.spn.value.TextValue;
import org.sami.spn.vocabulary.Reserved;

/**
 * A name that the author can change, together with all references to it.
 *
 * @param title what is renamed, in words
 * @param fields what is asked, with the names as they are
 * @param edit makes the edit of the names that were given, in the order of the fields
 */
record Renaming(String title, Map<String, String> fields, Function<List<String>, Edit> edit) {
    Renaming {
        Objects.requireNonNull(title, "title");
        fields = java.util.Collections.unmodifiableMap(new LinkedHashMap<>(fields));
        Objects.requireNonNull(edit, "edit");
    }

    private static Map<String, String> names(String name, String id) {
        Map<String, String> fields = new LinkedHashMap<>();
        fields.put("Name", name);
        fields.put("Id", id);
        return fields;
    }

    /** A plan: its name for people, and its id in every reference to it. */
    static Renaming plan(Project project, Plan plan) {
        int uses = new Usages(project).ofPlan(plan.id()).size();
        return new Renaming("Rename plan, used in " + places(uses), names(plan.name(), plan.id()), given -> {
            List<Edit> edits = new ArrayList<>();
            if (!given.get(0).equals(plan.name())) {
                edits.add(new ProjectEdit.DescribePlan(plan.id(), given.get(0), plan.description(), plan.notes()));
            }
            if (!given.get(1).equals(plan.id())) {
                edits.add(new ProjectEdit.RenamePlan(plan.id(), given.get(1)));
            }
            return new EditSequence("Rename plan \"" + PlanTree.name(plan) + "\"", edits);
        });
    }

    /** A variable of a plan, or with an empty one of the project, in all plans that see it. */
    static Renaming variable(Project project, Optional<String> plan, String name) {
        int uses = new Usages(project).ofVariable(plan, name).size();
        return new Renaming(
                "Rename variable, used in " + places(uses),
                Map.of("Name", name),
                given -> new RenameVariable(
                        plan, name, given.get(0).startsWith("@") ? given.get(0) : "@" + given.get(0)));
    }

    /** A folder of the mission tree. */
    static Renaming folder(Project project, TreeItem folder) {
        return new Renaming(
                "Rename folder",
                Map.of("Name", folder.title()),
                given -> PlanTree.labelFolder(project, folder, given.get(0)));
    }

    /** The project itself. */
    static Renaming project(Project project) {
        return new Renaming(
                "Rename project", Map.of("Name", project.name()), given -> new ProjectEdit.NameProject(given.get(0)));
    }

    /**
     * A place or a transition, with the ids of its events and sub-missions and the names of the interrupts that it takes; empty where the
     * plan has no such vertex.
     */
    static Optional<Renaming> vertex(Project project, Plan plan, String id) {
        Optional<String> place = plan.place(id).map(Place::name);
        Optional<Transition> transition = plan.transition(id);
        return place.or(() -> transition.map(Transition::name)).map(name -> {
            String what = place.isPresent() ? "place" : "transition";
            List<Named> parts = parts(plan, id);
            Map<String, String> fields = names(name, id);
            parts.forEach(part -> fields.put(part.label(), part.name()));
            int uses = new Usages(project).ofElement(plan.id(), id).size();
            return new Renaming("Rename " + what + ", used in " + places(uses), fields, given -> {
                List<Edit> edits = new ArrayList<>();
                if (!given.get(0).equals(name)) {
                    edits.add(new VertexEdit.NameVertex(plan.id(), id, given.get(0)));
                }
                for (int i = 0; i < parts.size(); i++) {
                    if (!given.get(i + 2).equals(parts.get(i).name())) {
                        edits.add(parts.get(i).edit().apply(given.get(i + 2)));
                    }
                }
                if (!given.get(1).equals(id)) {
                    edits.add(new RenameElement(plan.id(), id, given.get(1)));
                }
                return new EditSequence("Rename " + what + " \"" + (name.isEmpty() ? id : name) + "\"", edits);
            });
        });
    }

    /** A name that a vertex holds, and the edit that changes it. */
    private record Named(String label, String name, Function<String, Edit> edit) {}

    private static List<Named> parts(Plan plan, String vertex) {
        List<Named> parts = new ArrayList<>();
        plan.place(vertex).ifPresent(place -> {
            place.outputs().forEach(event -> parts.add(element(plan, "Event", event.id(), parts)));
            place.subMissions().forEach(sub -> parts.add(element(plan, "Sub-mission", sub.id(), parts)));
        });
        plan.transition(vertex)
                .ifPresent(transition -> transition.inputs().forEach(event -> {
                    parts.add(element(plan, "Event", event.id(), parts));
                    if (event.fields().get(Reserved.INTERRUPT_NAME) instanceof TextValue interrupt) {
                        parts.add(new Named(
                                numbered("Interrupt", parts),
                                interrupt.value(),
                                name -> new RenameInterrupt(interrupt.value(), name)));
                    }
                }));
        return parts;
    }

    private static Named element(Plan plan, String word, String id, List<Named> before) {
        return new Named(numbered(word, before), id, given -> new RenameElement(plan.id(), id, given));
    }

    /** The word, with a number where it is not the first. */
    private static String numbered(String word, List<Named> before) {
        long same =
                before.stream().filter(part -> part.label().startsWith(word)).count();
        return same == 0 ? word : word + " " + (same + 1);
    }

    /** A sub-mission of a plan: its id, and name and id of the plan that it runs. */
    static Renaming subMission(Project project, Plan parent, String id, Plan runs) {
        Renaming plan = plan(project, runs);
        Map<String, String> fields = new LinkedHashMap<>(plan.fields());
        fields.put("Sub-mission", id);
        return new Renaming(plan.title(), fields, given -> {
            List<Edit> edits = new ArrayList<>();
            if (!given.get(2).equals(id)) {
                edits.add(new RenameElement(parent.id(), id, given.get(2)));
            }
            edits.add(plan.edit().apply(given.subList(0, 2)));
            return new EditSequence("Rename sub-mission \"" + id + "\"", edits);
        });
    }

    /** A task of a plan, in every request and in every mapping to or from a parent. */
    static Renaming task(Project project, String plan, String name) {
        int uses = new Usages(project).ofTask(plan, name).size();
        return new Renaming(
                "Rename task, used in " + places(uses),
                Map.of("Name", name),
                given -> new TaskEdit.RenameTask(plan, name, given.get(0)));
    }

    private static String places(int uses) {
        return uses + (uses == 1 ? " place" : " places");
    }
}
