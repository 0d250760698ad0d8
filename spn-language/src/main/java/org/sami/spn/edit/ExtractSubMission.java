package org.sami.spn.edit;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.sami.spn.model.Action;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Mode;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.model.TaskSpec;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;
import org.sami.spn.model.WaitFor;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Makes a plan of its own of some vertices; a place with that plan as static sub-mission stands in their stead, and behind it a transition
 * that takes on what returns ({@link ExtractionBorder} says what can be extracted). Variables stay with the plan, and the new one reads
 * them; tasks that it names are given to it.
 *
 * @param elements ids of vertices; other ids in it, such as those of edges, are passed over
 * @param id of the new plan
 * @param name of the new plan and of the place
 */
public record ExtractSubMission(String plan, Set<String> elements, String id, String name) implements Edit {
    public ExtractSubMission {
        Objects.requireNonNull(plan, "plan");
        Objects.requireNonNull(id, "id");
        Objects.requireNonNull(name, "name");
        elements = Collections.unmodifiableSet(new LinkedHashSet<>(elements));
    }

    @Override
    public String label() {
        return "Extract sub-mission \"" + id + "\"";
    }

    /** Why the elements cannot be extracted, in one sentence; empty where they can. */
    public static Optional<String> whyNot(Plan plan, Set<String> elements, Vocabulary vocabulary) {
        try {
            ExtractionBorder.of(plan, elements, vocabulary);
            return Optional.empty();
        } catch (EditRefusedException e) {
            return Optional.of(e.reason());
        }
    }

    @Override
    public Project change(Project project, EditContext context) throws EditRefusedException {
        Plan before = Parts.plan(project, plan);
        if (project.plan(id).isPresent()) {
            throw new EditRefusedException("The project has a plan \"" + id + "\" already");
        }
        ExtractionBorder border = ExtractionBorder.of(before, elements, context.vocabulary());
        Plan child = child(before, border, project);
        Plan parent = parent(before, border, child);
        Project extracted = project.withPlans(Parts.replaced(project.plans(), p -> p.id().equals(plan), p -> parent));
        context.tell("The plan \"" + id + "\" takes who enters it one by one, and gives back who reaches its end");
        return new ProjectEdit.AddPlan(child).change(extracted, context);
    }

    private Plan child(Plan before, ExtractionBorder border, Project project) {
        Plan part = Fragment.copyOf(before, elements).part();
        String end = Parts.freshId(Parts.ids(part), "end");
        List<Place> places = new ArrayList<>(
                Parts.replaced(part.places(), p -> p.id().equals(border.entry()), p -> p.withStart(true)));
        places.add(new Place(end, "End", false, true, false, Mode.NOMINAL, List.of(), List.of(), List.of()));
        List<OutEdge> outEdges = new ArrayList<>();
        for (OutEdge edge : before.outEdges()) {
            if (border.isInside(edge.place(), edge.transition())) {
                outEdges.add(edge);
            } else if (border.leadsOut(edge)) {
                outEdges.add(edge.withPlace(end));
            }
        }
        Map<String, LayoutPoint> layout = new LinkedHashMap<>(part.layout());
        if (before.layout().containsKey(border.exit())) {
            layout.put(end, before.layout().get(border.exit()));
        }
        Set<String> reads = new TreeSet<>();
        PlanNames.forEach(part, use -> {
            if (use.kind() == NameUse.Kind.VARIABLE && use.of().equals(before.id()) && isKnown(before, project, use)) {
                reads.add(use.name());
            }
        });
        return part.withId(id)
                .withName(name)
                .withDescription("")
                .withVariables(List.of())
                .withReads(List.copyOf(reads))
                .withPlaces(places)
                .withOutEdges(outEdges)
                .withLayout(layout);
    }

    /** Whether a parent or the project has the variable; one that nobody declares is the new plan's own. */
    private static boolean isKnown(Plan before, Project project, NameUse use) {
        return before.reads().contains(use.name())
                || before.variables().stream().anyMatch(v -> v.name().equals(use.name()))
                || project.globals().stream().anyMatch(v -> v.name().equals(use.name()));
    }

    private Plan parent(Plan before, ExtractionBorder border, Plan child) {
        Set<String> taken = new HashSet<>(Parts.ids(before));
        String place = taking(taken, id);
        String run = taking(taken, place + "-run");
        String returned = taking(taken, place + "-returned");
        Mode mode = before.places().stream()
                        .filter(p -> border.places().contains(p.id()))
                        .allMatch(p -> p.mode() == Mode.RECOVERY)
                ? Mode.RECOVERY
                : Mode.NOMINAL;
        Map<String, String> tasks = new LinkedHashMap<>();
        child.tasks().stream().map(TaskSpec::name).forEach(task -> tasks.put(task, task));
        SubMissionSpec sub = new SubMissionSpec(run, id, true, tasks, Map.of());
        List<Place> places = new ArrayList<>(
                Parts.without(before.places(), p -> border.places().contains(p.id())));
        places.add(new Place(place, name, false, false, false, mode, List.of(), List.of(sub), List.of()));
        List<Transition> transitions = new ArrayList<>(
                Parts.without(before.transitions(), t -> border.transitions().contains(t.id())));
        transitions.add(new Transition(returned, "", mode, WaitFor.EACH, List.of()));
        List<InEdge> inEdges =
                new ArrayList<>(Parts.without(before.inEdges(), e -> border.isInside(e.place(), e.transition())));
        inEdges.add(new InEdge(
                taking(taken, place + "-" + returned), place, returned, mode, List.of(InRequirement.unconditional())));
        List<OutEdge> outEdges = new ArrayList<>();
        for (OutEdge edge : before.outEdges()) {
            if (border.leadsIn(edge)) {
                outEdges.add(edge.withPlace(place));
            } else if (!border.transitions().contains(edge.transition())) {
                outEdges.add(edge);
            }
        }
        outEdges.add(new OutEdge(
                taking(taken, returned + "-" + border.exit()),
                returned,
                border.exit(),
                mode,
                List.of(OutRequirement.of(Action.TAKE, OutRequirement.ALL, TokenKind.SUB_MISSION_TOKENS))));
        return before.withPlaces(places)
                .withTransitions(transitions)
                .withInEdges(inEdges)
                .withOutEdges(outEdges)
                .withLayout(layout(before, border, place, returned));
    }

    private static String taking(Set<String> taken, String word) {
        String fresh = Parts.freshId(taken, word);
        taken.add(fresh);
        return fresh;
    }

    /** The place in the middle of what it stands for, and the transition between it and the exit. */
    private static Map<String, LayoutPoint> layout(
            Plan before, ExtractionBorder border, String place, String returned) {
        Map<String, LayoutPoint> layout = new LinkedHashMap<>(before.layout());
        List<LayoutPoint> points = border.places().stream()
                .filter(layout::containsKey)
                .map(layout::get)
                .toList();
        layout.keySet()
                .removeIf(id ->
                        border.places().contains(id) || border.transitions().contains(id));
        if (!points.isEmpty()) {
            double x = points.stream().mapToDouble(LayoutPoint::x).average().orElseThrow();
            double y = points.stream().mapToDouble(LayoutPoint::y).average().orElseThrow();
            layout.put(place, new LayoutPoint(x, y));
            LayoutPoint exit = layout.get(border.exit());
            if (exit != null) {
                layout.put(returned, new LayoutPoint((x + exit.x()) / 2, (y + exit.y()) / 2));
            }
        }
        return layout;
    }
}
