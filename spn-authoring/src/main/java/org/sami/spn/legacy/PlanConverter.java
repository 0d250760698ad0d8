package org.sami.spn.legacy;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.json.JsonObjectReader;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Mode;
import org.sami.spn.model.Note;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.model.TaskSpec;
import org.sami.spn.model.Transition;
import org.sami.spn.model.WaitFor;
import org.sami.spn.vocabulary.Vocabulary;

/** Makes a plan of this language of one of the export's. Variables are declared later, when all plans are there. */
final class PlanConverter {
    private final Vocabulary vocabulary;
    private final LegacyTable table;
    private final Copies copies;
    private final EventConverter events;
    private final RequirementConverter requirements;
    private final Findings findings;
    private final Counts.Tally explained;

    PlanConverter(
            Vocabulary vocabulary,
            LegacyTable table,
            Copies copies,
            EventConverter events,
            RequirementConverter requirements,
            Findings findings,
            Counts.Tally explained) {
        this.vocabulary = vocabulary;
        this.table = table;
        this.copies = copies;
        this.events = events;
        this.requirements = requirements;
        this.findings = findings;
        this.explained = explained;
    }

    Plan convert(LegacyPlan plan) {
        tellAbout(plan);
        List<String> notes = new ArrayList<>();
        List<Place> places = plan.places().stream().map(v -> place(v, notes)).toList();
        List<Transition> transitions =
                plan.transitions().stream().map(v -> transition(v, notes)).toList();
        Map<String, LayoutPoint> layout = new LinkedHashMap<>();
        plan.vertices().forEach(v -> layout.put(v.key(), new LayoutPoint(v.x(), v.y())));
        plan.edges().forEach(e -> e.mockup().ifPresent(m -> notes.add("Mock-up of edge " + e.key() + ": " + m.node())));
        return new Plan(
                plan.id(),
                plan.name(),
                "",
                places,
                transitions,
                inEdges(plan),
                outEdges(plan),
                List.of(),
                List.of(),
                tasks(plan),
                layout,
                notes.stream().map(Note::of).toList(),
                List.of());
    }

    private void tellAbout(LegacyPlan plan) {
        String title = "The plan " + plan.id() + " (" + plan.name() + ")";
        if (!plan.hasStart()) {
            findings.warning(
                    LegacyCodes.HEADING,
                    plan.pointer(),
                    title + " has no start place: it cannot be run"
                            + (plan.edges().isEmpty() ? "; it is empty, as headings of the plan list are" : ""),
                    plan.id());
        }
        if (plan.danglingEdgeRefs() > 0) {
            findings.note(
                    LegacyCodes.LEFT_BEHIND,
                    plan.pointer(),
                    title + " held " + plan.danglingEdgeRefs() + " references to edges that were deleted; the export "
                            + "leaves them out, the earlier engine would still have followed them",
                    plan.id());
        }
        plan.transitions().forEach(t -> tellIfItMovesNobody(plan, t));
        long hidden = count(plan, LegacyPlan.DrawingMode.HIDDEN_RECOVERY);
        long mockup = count(plan, LegacyPlan.DrawingMode.MOCKUP);
        if (hidden + mockup > 0) {
            findings.note(
                    LegacyCodes.MODE,
                    plan.pointer(),
                    title + " has " + hidden + " hidden recovery elements, which are recovery elements here, and "
                            + mockup
                            + " of a mock-up, which are nominal; what the mock-up says in words is kept as notes",
                    plan.id());
        }
    }

    /** It asks for boats or tasks by name and has nowhere to take them: who answered stays where it is. */
    private void tellIfItMovesNobody(LegacyPlan plan, LegacyPlan.Vertex t) {
        boolean asks = plan.edges().stream()
                .filter(e -> e.in() && e.to().equals(t.key()))
                .flatMap(e -> e.requirements().stream())
                .anyMatch(r -> r.kind() == LegacyPlan.Kind.RELEVANT);
        List<LegacyPlan.Edge> out = plan.edges().stream()
                .filter(e -> !e.in() && e.from().equals(t.key()))
                .toList();
        if (asks
                && !out.isEmpty()
                && out.stream().allMatch(e -> e.requirements().isEmpty())
                && !t.events().isEmpty()) {
            findings.warning(
                    LegacyCodes.MOVES_NOBODY,
                    t.pointer(),
                    "The transition " + t.title() + " of the plan " + plan.id() + " (" + plan.name() + ") waits for "
                            + t.events().get(0).className().replaceAll(".*\\.", "")
                            + " of named boats or tasks and moves none of them: they stay where they are",
                    plan.id(),
                    t.key());
        }
    }

    private static long count(LegacyPlan plan, LegacyPlan.DrawingMode mode) {
        return plan.vertices().stream().filter(v -> v.mode() == mode).count()
                + plan.edges().stream().filter(e -> e.mode() == mode).count();
    }

    private static Mode mode(LegacyPlan.DrawingMode mode) {
        return mode == LegacyPlan.DrawingMode.RECOVERY || mode == LegacyPlan.DrawingMode.HIDDEN_RECOVERY
                ? Mode.RECOVERY
                : Mode.NOMINAL;
    }

    private Place place(LegacyPlan.Vertex v, List<String> notes) {
        v.mockup().ifPresent(m -> notes.add("Mock-up of place " + v.title() + ": " + m.node()));
        List<SubMissionSpec> subMissions = new ArrayList<>();
        for (LegacyPlan.SubMission s : v.subMissions()) {
            Optional<Copies.Fold> fold = copies.of(s.plan());
            subMissions.add(new SubMissionSpec(
                    v.key() + ".s" + subMissions.size(),
                    fold.map(Copies.Fold::plan).orElse(s.plan()),
                    s.shared(),
                    s.tasks(),
                    fold.map(Copies.Fold::variables).orElse(Map.of())));
        }
        return new Place(
                v.key(),
                v.name(),
                v.start(),
                v.end(),
                v.end() && v.endsShared(),
                mode(v.mode()),
                events.outputs(v, notes),
                subMissions,
                v.outTransitions());
    }

    private Transition transition(LegacyPlan.Vertex v, List<String> notes) {
        v.mockup().ifPresent(m -> notes.add("Mock-up of transition " + v.title() + ": " + m.node()));
        return new Transition(
                v.key(),
                v.name(),
                mode(v.mode()),
                events.waitsForAll(v) ? WaitFor.ALL : WaitFor.EACH,
                events.inputs(v, notes));
    }

    /** Edges in the order in which their transition looks at them; those that it does not order follow. */
    private static List<LegacyPlan.Edge> ordered(LegacyPlan plan, boolean in) {
        Map<String, Integer> rank = new HashMap<>();
        for (LegacyPlan.Vertex t : plan.transitions()) {
            List<String> order = in ? t.inPlaces() : t.outPlaces();
            for (int i = 0; i < order.size(); i++) {
                rank.put(t.key() + " " + order.get(i), i);
            }
        }
        List<String> transitions =
                plan.transitions().stream().map(LegacyPlan.Vertex::key).toList();
        List<LegacyPlan.Edge> edges =
                plan.edges().stream().filter(e -> e.in() == in).toList();
        return edges.stream()
                .sorted(Comparator.<LegacyPlan.Edge>comparingInt(e -> transitions.indexOf(in ? e.to() : e.from()))
                        .thenComparingInt(e -> rank.getOrDefault(
                                in ? e.to() + " " + e.from() : e.from() + " " + e.to(), Integer.MAX_VALUE)))
                .toList();
    }

    private List<InEdge> inEdges(LegacyPlan plan) {
        Map<String, InEdge> edges = new LinkedHashMap<>();
        for (LegacyPlan.Edge e : ordered(plan, true)) {
            List<InRequirement> own = requirements.in(e);
            edges.merge(e.from() + " " + e.to(), new InEdge(e.key(), e.from(), e.to(), mode(e.mode()), own), (a, b) -> {
                tellParallel(e, a.id(), CountedKind.IN_EDGES);
                List<InRequirement> both = new ArrayList<>(a.requirements());
                both.addAll(b.requirements());
                return new InEdge(a.id(), a.place(), a.transition(), a.mode(), both);
            });
        }
        return List.copyOf(edges.values());
    }

    private List<OutEdge> outEdges(LegacyPlan plan) {
        Map<String, OutEdge> edges = new LinkedHashMap<>();
        for (LegacyPlan.Edge e : ordered(plan, false)) {
            List<OutRequirement> own = requirements.out(e);
            edges.merge(
                    e.from() + " " + e.to(), new OutEdge(e.key(), e.from(), e.to(), mode(e.mode()), own), (a, b) -> {
                        tellParallel(e, a.id(), CountedKind.OUT_EDGES);
                        List<OutRequirement> both = new ArrayList<>(a.requirements());
                        both.addAll(b.requirements());
                        return new OutEdge(a.id(), a.transition(), a.place(), a.mode(), both);
                    });
        }
        return List.copyOf(edges.values());
    }

    private void tellParallel(LegacyPlan.Edge e, String other, CountedKind kind) {
        explained.add(kind, 1);
        findings.warning(
                LegacyCodes.PARALLEL_EDGE,
                e.pointer(),
                "The edge " + e.key() + " joins what " + other
                        + " joins already; its requirements are added to that one",
                e.key());
    }

    private List<TaskSpec> tasks(LegacyPlan plan) {
        List<TaskSpec> tasks = new ArrayList<>();
        for (LegacyPlan.Task task : plan.tasks()) {
            String simple = LegacyPlan.simpleName(task.className());
            String taskClass =
                    LegacyTable.find(table.taskClasses(), task.className()).orElse(simple);
            if (vocabulary.taskClasses().containsKey(taskClass)) {
                tasks.add(new TaskSpec(task.name(), taskClass, Map.of()));
            } else {
                explained.add(CountedKind.TASKS, 1);
                findings.warning(
                        LegacyCodes.UNKNOWN_CLASS,
                        JsonObjectReader.at(task.pointer(), "class"),
                        "The task " + task.name() + " is of the class " + task.className()
                                + ", which is not known here; it is not imported",
                        task.name());
            }
        }
        return tasks;
    }
}
