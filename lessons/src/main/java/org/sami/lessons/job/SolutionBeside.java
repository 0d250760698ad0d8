package org.sami.lessons.job;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.BiConsumer;
import java.util.function.BiFunction;
import java.util.function.Function;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;

/**
 * A solution with the ids and names of a learner's plan, wherever a vertex of one stands for a vertex of the other: a comparison of both then says what differs, not
 * who drew it. What the learner's plan does not have keeps its own ids.
 */
public final class SolutionBeside {
    private static final int SAME_EVENTS = 3;
    private static final int SAME_NEIGHBOUR = 2;

    private final Plan solution;
    private final Plan mine;
    private final Map<String, Vertex> vertices;
    private final Map<String, Vertex> others;
    private final Map<String, String> to = new LinkedHashMap<>();

    /** What of a vertex tells it from others. */
    private record Vertex(
            boolean place, boolean start, boolean end, List<String> events, Set<String> in, Set<String> out) {
        boolean isLike(Vertex other) {
            return place == other.place;
        }
    }

    private SolutionBeside(Plan solution, Plan mine) {
        this.solution = solution;
        this.mine = mine;
        vertices = vertices(solution);
        others = vertices(mine);
    }

    /** A solution in the words of a learner's plan. */
    public static Plan of(Plan solution, Plan mine) {
        return new SolutionBeside(solution, mine).renamed();
    }

    private static Map<String, Vertex> vertices(Plan plan) {
        Map<String, Set<String>> in = new HashMap<>();
        Map<String, Set<String>> out = new HashMap<>();
        BiConsumer<String, String> join = (from, to) -> {
            out.computeIfAbsent(from, each -> new TreeSet<>()).add(to);
            in.computeIfAbsent(to, each -> new TreeSet<>()).add(from);
        };
        plan.inEdges().forEach(edge -> join.accept(edge.place(), edge.transition()));
        plan.outEdges().forEach(edge -> join.accept(edge.transition(), edge.place()));
        Map<String, Vertex> vertices = new LinkedHashMap<>();
        for (Place place : plan.places()) {
            List<String> events = new ArrayList<>();
            place.outputs().forEach(event -> events.add(event.type()));
            place.subMissions().forEach(sub -> events.add(sub.plan()));
            vertices.put(place.id(), vertex(true, place.start(), place.end(), events, place.id(), in, out));
        }
        for (Transition transition : plan.transitions()) {
            List<String> events =
                    transition.inputs().stream().map(event -> event.type()).toList();
            vertices.put(transition.id(), vertex(false, false, false, events, transition.id(), in, out));
        }
        return vertices;
    }

    private static Vertex vertex(
            boolean place,
            boolean start,
            boolean end,
            List<String> events,
            String id,
            Map<String, Set<String>> in,
            Map<String, Set<String>> out) {
        return new Vertex(
                place,
                start,
                end,
                events.stream().sorted().toList(),
                in.getOrDefault(id, Set.of()),
                out.getOrDefault(id, Set.of()));
    }

    /** First those of one id, then again and again the pair that has most in common. */
    private void match() {
        vertices.forEach((id, vertex) -> {
            Vertex other = others.get(id);
            if (other != null && vertex.isLike(other)) {
                to.put(id, id);
            }
        });
        for (Optional<Map.Entry<String, String>> best = best(); best.isPresent(); best = best()) {
            to.put(best.get().getKey(), best.get().getValue());
        }
    }

    private Optional<Map.Entry<String, String>> best() {
        Optional<Map.Entry<String, String>> best = Optional.empty();
        int most = SAME_NEIGHBOUR; // nothing but one neighbour in common is too little where events differ
        for (Map.Entry<String, Vertex> one : vertices.entrySet()) {
            for (Map.Entry<String, Vertex> other : others.entrySet()) {
                int score = to.containsKey(one.getKey()) || to.containsValue(other.getKey())
                        ? 0
                        : score(one.getValue(), other.getValue());
                if (score > most) {
                    most = score;
                    best = Optional.of(Map.entry(one.getKey(), other.getKey()));
                }
            }
        }
        return best;
    }

    private int score(Vertex one, Vertex other) {
        if (!one.isLike(other)) {
            return 0;
        }
        int neighbours = common(one.in(), other.in()) + common(one.out(), other.out());
        boolean events = one.events().equals(other.events());
        return (one.start() && other.start())
                        || (events && (neighbours > 0 || !one.events().isEmpty()))
                ? SAME_EVENTS + SAME_NEIGHBOUR * neighbours + (one.end() == other.end() ? 1 : 0)
                : SAME_NEIGHBOUR * neighbours;
    }

    private int common(Set<String> mineOf, Set<String> theirs) {
        return (int) mineOf.stream()
                .filter(id -> to.containsKey(id) && theirs.contains(to.get(id)))
                .count();
    }

    // ---- Renaming

    private Plan renamed() {
        match();
        Set<String> taken = new HashSet<>(mine.elementIds());
        vertices.keySet().stream().filter(id -> !to.containsKey(id)).forEach(id -> to.put(id, fresh(id, taken)));
        Map<String, LayoutPoint> layout = new LinkedHashMap<>();
        solution.layout().forEach((id, at) -> {
            String there = to.getOrDefault(id, id);
            layout.put(there, mine.layout().getOrDefault(there, at));
        });
        return solution.withName(mine.name())
                .withDescription(mine.description())
                .withNotes(mine.notes())
                .withFrames(mine.frames())
                .withTestCases(mine.testCases())
                .withLayout(layout)
                .withPlaces(solution.places().stream()
                        .map(place -> place(place, taken))
                        .toList())
                .withTransitions(solution.transitions().stream()
                        .map(transition -> transition(transition, taken))
                        .toList())
                .withInEdges(solution.inEdges().stream()
                        .map(edge -> edge(edge, taken))
                        .toList())
                .withOutEdges(solution.outEdges().stream()
                        .map(edge -> edge(edge, taken))
                        .toList());
    }

    private static String fresh(String id, Set<String> taken) {
        String fresh = id;
        while (!taken.add(fresh)) {
            fresh += "-solution";
        }
        return fresh;
    }

    private String vertex(String id) {
        return to.getOrDefault(id, id);
    }

    private Place place(Place place, Set<String> taken) {
        Optional<Place> same = mine.place(vertex(place.id()));
        return place.withId(vertex(place.id()))
                .withName(same.map(Place::name).orElse(place.name()))
                .withTransitionOrder(
                        place.transitionOrder().stream().map(this::vertex).toList())
                .withOutputs(likewise(
                        place.outputs(),
                        same.map(Place::outputs).orElse(List.of()),
                        event -> event.type(),
                        event -> event.id(),
                        (event, id) -> event.withId(id),
                        taken))
                .withSubMissions(likewise(
                        place.subMissions(),
                        same.map(Place::subMissions).orElse(List.of()),
                        sub -> sub.plan(),
                        sub -> sub.id(),
                        (sub, id) -> sub.withId(id),
                        taken));
    }

    private Transition transition(Transition transition, Set<String> taken) {
        Optional<Transition> same = mine.transition(vertex(transition.id()));
        return transition
                .withId(vertex(transition.id()))
                .withName(same.map(Transition::name).orElse(transition.name()))
                .withInputs(likewise(
                        transition.inputs(),
                        same.map(Transition::inputs).orElse(List.of()),
                        event -> event.type(),
                        event -> event.id(),
                        (event, id) -> event.withId(id),
                        taken));
    }

    /** Parts with the ids of those of the same kind on the learner's vertex. */
    private static <T> List<T> likewise(
            List<T> parts,
            List<T> same,
            Function<T, String> kind,
            Function<T, String> id,
            BiFunction<T, String, T> withId,
            Set<String> taken) {
        List<T> left = new ArrayList<>(same);
        List<T> renamed = new ArrayList<>();
        for (T part : parts) {
            Optional<T> like = left.stream()
                    .filter(each -> kind.apply(each).equals(kind.apply(part)))
                    .findFirst();
            like.ifPresent(left::remove);
            renamed.add(withId.apply(part, like.map(id).orElseGet(() -> fresh(id.apply(part), taken))));
        }
        return renamed;
    }

    private InEdge edge(InEdge edge, Set<String> taken) {
        String place = vertex(edge.place());
        String transition = vertex(edge.transition());
        String id = mine.inEdges().stream()
                .filter(each -> each.place().equals(place) && each.transition().equals(transition))
                .map(InEdge::id)
                .findFirst()
                .orElseGet(() -> fresh(edge.id(), taken));
        return edge.withId(id).withPlace(place).withTransition(transition);
    }

    private OutEdge edge(OutEdge edge, Set<String> taken) {
        String place = vertex(edge.place());
        String transition = vertex(edge.transition());
        String id = mine.outEdges().stream()
                .filter(each -> each.place().equals(place) && each.transition().equals(transition))
                .map(OutEdge::id)
                .findFirst()
                .orElseGet(() -> fresh(edge.id(), taken));
        return edge.withId(id).withPlace(place).withTransition(transition);
    }
}
