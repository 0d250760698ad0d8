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
import org.sami.spn.edit.Usages;
import org.sami.spn.edit.VertexEdit;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.Transition;
import org.sami.spn.value.TextValue;
import org.sami.spn.vocabulary.Reserved;

/**
 * A name that the author may change, wherever it is spoken of.
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

    /** A plan: its name for people, and its id wherever it is run or referred to. */
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

    /** A place or a transition, or the interrupt that a transition takes; empty where the plan has no such vertex. */
    static Optional<Renaming> vertex(Project project, Plan plan, String id) {
        Optional<String> place = plan.places().stream()
                .filter(p -> p.id().equals(id))
                .map(Place::name)
                .findFirst();
        Optional<Transition> transition =
                plan.transitions().stream().filter(t -> t.id().equals(id)).findFirst();
        return place.or(() -> transition.map(Transition::name)).map(name -> {
            String what = place.isPresent() ? "place" : "transition";
            int uses = new Usages(project).ofElement(plan.id(), id).size();
            return new Renaming("Rename " + what + ", used in " + places(uses), names(name, id), given -> {
                List<Edit> edits = new ArrayList<>();
                if (!given.get(0).equals(name)) {
                    edits.add(new VertexEdit.NameVertex(plan.id(), id, given.get(0)));
                }
                if (!given.get(1).equals(id)) {
                    edits.add(new RenameElement(plan.id(), id, given.get(1)));
                }
                return new EditSequence("Rename " + what + " \"" + (name.isEmpty() ? id : name) + "\"", edits);
            });
        });
    }

    /** The interrupt whose name an event holds, in all plans; empty where the element is no such event. */
    static Optional<Renaming> interrupt(Project project, Plan plan, String element) {
        return plan.transitions().stream()
                .filter(t -> t.id().equals(element) || t.inputs().stream().anyMatch(e -> e.id().equals(element)))
                .flatMap(t -> t.inputs().stream())
                .map(InputEventSpec::fields)
                .filter(fields -> fields.get(Reserved.INTERRUPT_NAME) instanceof TextValue)
                .map(fields -> ((TextValue) fields.get(Reserved.INTERRUPT_NAME)).value())
                .findFirst()
                .map(name -> new Renaming(
                        "Rename interrupt, used in "
                                + places(new Usages(project).ofInterrupt(name).size()),
                        Map.of("Name", name),
                        given -> new RenameInterrupt(name, given.get(0))));
    }

    private static String places(int uses) {
        return uses + (uses == 1 ? " place" : " places");
    }
}
