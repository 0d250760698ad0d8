package org.sami.dreamm.compare;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Stream;
import org.sami.picture.net.NetChange;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Mode;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * In what a plan differs from an earlier version. Elements are the same where they have one id.
 *
 * @param both the plan as it is, with what is gone where it was: for a net that shows both
 * @param changes what became of vertices and edges, by their ids in {@code both}
 * @param differences in words
 */
public record PlanComparison(Plan both, Map<String, NetChange> changes, List<Difference> differences) {
    public PlanComparison {
        changes = Collections.unmodifiableMap(new LinkedHashMap<>(changes));
        differences = List.copyOf(differences);
    }

    /** Compares two versions of a plan. */
    public static PlanComparison of(Plan before, Plan after, Vocabulary vocabulary) {
        return new Builder(before, after, vocabulary).build();
    }

    /** Whether both are equal, apart from the positions of their vertices. */
    public boolean isEmpty() {
        return differences.isEmpty();
    }

    /** Whether all vertices and edges that differ are drawn in the nominal plan. */
    boolean isNominal() {
        return Stream.of(
                        both.places().stream().map(p -> Map.entry(p.id(), p.mode())),
                        both.transitions().stream().map(t -> Map.entry(t.id(), t.mode())),
                        both.inEdges().stream().map(e -> Map.entry(e.id(), e.mode())),
                        both.outEdges().stream().map(e -> Map.entry(e.id(), e.mode())))
                .flatMap(each -> each)
                .filter(element -> changes.containsKey(element.getKey()))
                .allMatch(element -> element.getValue() == Mode.NOMINAL);
    }

    /** The vertices among elements, and those at the ends of their edges. */
    Set<String> vertices(Set<String> elements) {
        Set<String> vertices = new HashSet<>(elements);
        both.inEdges().stream().filter(e -> elements.contains(e.id())).forEach(e -> {
            vertices.add(e.place());
            vertices.add(e.transition());
        });
        both.outEdges().stream().filter(e -> elements.contains(e.id())).forEach(e -> {
            vertices.add(e.place());
            vertices.add(e.transition());
        });
        return vertices;
    }

    private static final class Builder {
        private final Plan before;
        private final Plan after;
        private final DifferenceWords words;
        private final Map<String, NetChange> changes = new LinkedHashMap<>();
        private final List<Difference> differences = new ArrayList<>();
        private final Map<String, String> goneIds = new LinkedHashMap<>();

        Builder(Plan before, Plan after, Vocabulary vocabulary) {
            this.before = before;
            this.after = after;
            this.words = new DifferenceWords(before, after, vocabulary);
        }

        PlanComparison build() {
            PlanWords.differences(before, after).forEach(text -> differences.add(new Difference(text, Set.of())));
            Set<String> kept = new HashSet<>();
            after.places().forEach(p -> kept.add(p.id()));
            after.transitions().forEach(t -> kept.add(t.id()));
            after.inEdges().forEach(e -> kept.add(e.id()));
            after.outEdges().forEach(e -> kept.add(e.id()));
            List<Place> gonePlaces =
                    compared(before.places(), after.places(), Place::id, words::name, words::changes, kept);
            List<Transition> goneTransitions = compared(
                    before.transitions(), after.transitions(), Transition::id, words::name, words::changes, kept);
            List<InEdge> goneIn =
                    compared(before.inEdges(), after.inEdges(), InEdge::id, words::name, words::changes, kept);
            List<OutEdge> goneOut =
                    compared(before.outEdges(), after.outEdges(), OutEdge::id, words::name, words::changes, kept);
            moved();
            PlanWords.casesAndQueries(before, after).forEach(text -> differences.add(new Difference(text, Set.of())));
            return new PlanComparison(both(gonePlaces, goneTransitions, goneIn, goneOut), changes, differences);
        }

        private interface Changes<T> {
            List<String> of(T before, T after);
        }

        /** Tells what is new, gone or changed; the result is what is gone. */
        private <T> List<T> compared(
                List<T> old,
                List<T> now,
                Function<T, String> id,
                Function<T, String> name,
                Changes<T> how,
                Set<String> kept) {
            Map<String, T> earlier = new LinkedHashMap<>();
            old.forEach(each -> earlier.put(id.apply(each), each));
            for (T each : now) {
                T was = earlier.remove(id.apply(each));
                if (was == null) {
                    mark(id.apply(each), NetChange.ADDED, name.apply(each) + " is new");
                } else {
                    for (String what : how.of(was, each)) {
                        mark(id.apply(each), NetChange.CHANGED, name.apply(each) + ": " + what);
                    }
                }
            }
            for (T each : earlier.values()) {
                String gone = id.apply(each);
                while (kept.contains(gone)) {
                    gone += " before"; // another kind of element has the id now
                }
                kept.add(gone);
                goneIds.put(id.apply(each), gone);
                mark(gone, NetChange.REMOVED, name.apply(each) + " is gone");
            }
            return List.copyOf(earlier.values());
        }

        private void mark(String id, NetChange change, String text) {
            changes.put(id, change);
            differences.add(new Difference(text, Set.of(id)));
        }

        private void moved() {
            Set<String> moved = new HashSet<>();
            before.layout().forEach((id, at) -> {
                LayoutPoint now = after.layout().get(id);
                if (now != null && !now.equals(at)) {
                    moved.add(id);
                }
            });
            if (!moved.isEmpty()) {
                String text =
                        moved.size() == 1 ? "One vertex lies elsewhere" : moved.size() + " vertices lie elsewhere";
                differences.add(new Difference(text, moved));
            }
        }

        private String now(String id) {
            boolean there = after.place(id).isPresent() || after.transition(id).isPresent();
            return there ? id : goneIds.getOrDefault(id, id);
        }

        /** The id under which a vertex or an edge that is gone is drawn. */
        private String goneId(String id) {
            return Objects.requireNonNull(goneIds.get(id), () -> id + " is not gone");
        }

        private Plan both(
                List<Place> places, List<Transition> transitions, List<InEdge> inEdges, List<OutEdge> outEdges) {
            List<Place> allPlaces = new ArrayList<>(after.places());
            places.forEach(p -> allPlaces.add(p.withId(goneId(p.id())).withTransitionOrder(List.of())));
            List<Transition> allTransitions = new ArrayList<>(after.transitions());
            transitions.forEach(t -> allTransitions.add(t.withId(goneId(t.id()))));
            List<InEdge> allIn = new ArrayList<>(after.inEdges());
            inEdges.forEach(e -> allIn.add(e.withId(goneId(e.id()))
                    .withPlace(goneOrNow(e.place(), places.stream().anyMatch(p -> p.id().equals(e.place()))))
                    .withTransition(goneOrNow(
                            e.transition(), transitions.stream().anyMatch(t -> t.id().equals(e.transition()))))));
            List<OutEdge> allOut = new ArrayList<>(after.outEdges());
            outEdges.forEach(e -> allOut.add(e.withId(goneId(e.id()))
                    .withPlace(goneOrNow(e.place(), places.stream().anyMatch(p -> p.id().equals(e.place()))))
                    .withTransition(goneOrNow(
                            e.transition(), transitions.stream().anyMatch(t -> t.id().equals(e.transition()))))));
            Map<String, LayoutPoint> layout = new LinkedHashMap<>(after.layout());
            goneIds.forEach((id, gone) -> {
                if (before.layout().containsKey(id)) {
                    layout.put(gone, before.layout().get(id));
                }
            });
            return after.withPlaces(allPlaces)
                    .withTransitions(allTransitions)
                    .withInEdges(allIn)
                    .withOutEdges(allOut)
                    .withLayout(layout);
        }

        private String goneOrNow(String id, boolean gone) {
            return gone ? Objects.requireNonNull(goneIds.get(id), id) : now(id);
        }
    }
}
