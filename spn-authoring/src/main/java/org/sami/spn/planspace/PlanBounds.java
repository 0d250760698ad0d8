package org.sami.spn.planspace;

import java.time.Duration;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.stream.IntStream;
import org.sami.petri.graph.GraphWatch;
import org.sami.petri.graph.ReachabilityGraph;
import org.sami.petri.graph.SearchBudget;
import org.sami.petri.structure.IntegerVector;
import org.sami.petri.structure.MarkingBound;
import org.sami.petri.structure.StructuralAnswers;
import org.sami.petri.structure.StructureLimits;
import org.sami.spn.model.Place;
import org.sami.spn.plannet.PlanNet;
import org.sami.spn.plannet.PlanNetPlace;
import org.sami.spn.plannet.PlanNetPlace.Role;
import org.sami.spn.plannet.PlanNetRequest;
import org.sami.spn.plannet.PlanNetTooLargeException;
import org.sami.spn.planspace.TokenBound.Kind;

/**
 * How many tokens can be in each place of a plan at once, and which places limit them: the largest numbers in all states of the plan's net, with the P-invariants that say
 * so where there are such. Immutable.
 *
 * @param plan its id
 * @param places in the order of the plan; none where not all states were looked at
 * @param summary what was looked at, in a sentence
 */
public record PlanBounds(String plan, List<PlaceBound> places, String summary) {
    private static final Duration MOST_STRUCTURE = Duration.ofSeconds(5);

    /** A sum of more places than that is said by how many they are. */
    private static final int MOST_NAMED = 4;

    public PlanBounds {
        places = List.copyOf(places);
    }

    /**
     * Searches, which may take as long as the budget allows.
     *
     * @throws PlanNetTooLargeException if the net of the plan would be too large
     * @throws IllegalArgumentException if there is no such plan, or it has no start place
     */
    public static PlanBounds of(PlanNetRequest request, SearchBudget budget, GraphWatch watch)
            throws PlanNetTooLargeException {
        Optional<PlanNet> counted = PlanNet.counted(request);
        PlanNet net = counted.isPresent() ? counted.get() : PlanNet.of(request);
        PlanFacts facts = new PlanQueries(net, budget, watch).whole();
        ReachabilityGraph graph = facts.graph();
        if (!graph.isComplete() || net.isPartial() || graph.mostTokens(net.beyond()) > 0) {
            String why = graph.isComplete()
                    ? "the net of the plan follows only a part of it"
                    : graph.end().words();
            return new PlanBounds(request.plan(), List.of(), "no bounds: " + why);
        }
        return new Search(net, facts, watch).bounds();
    }

    private static final class Search {
        private final PlanNet net;
        private final PlanFacts facts;
        private final StructuralAnswers structure;
        private final PlanStateWords words;
        private final Map<String, Map<Kind, List<Integer>>> netPlaces = new LinkedHashMap<>();

        Search(PlanNet net, PlanFacts facts, GraphWatch watch) {
            this.net = net;
            this.facts = facts;
            words = new PlanStateWords(net);
            long deadline = System.nanoTime() + MOST_STRUCTURE.toNanos();
            structure = new StructuralAnswers(
                    net.net(),
                    StructureLimits.USUAL.withCancel(watch::isCancelled).until(deadline, System::nanoTime));
            for (int i = 0; i < net.net().placeCount(); i++) {
                PlanNetPlace place = net.place(i);
                if (place.role() == Role.TOKEN) {
                    netPlaces
                            .computeIfAbsent(place.planPlace(), id -> new EnumMap<>(Kind.class))
                            .computeIfAbsent(kind(place), kind -> new ArrayList<>())
                            .add(i);
                }
            }
        }

        private Kind kind(PlanNetPlace place) {
            return net.isRobot(place.token()) ? Kind.ROBOT : place.token().startsWith("#") ? Kind.TASK : Kind.GENERIC;
        }

        PlanBounds bounds() {
            List<PlaceBound> bounds = net.request().project().plan(net.request().plan()).orElseThrow().places().stream()
                    .map(Place::id)
                    .map(this::bound)
                    .toList();
            return new PlanBounds(
                    net.request().plan(),
                    bounds,
                    "bounds of all " + facts.graph().states() + " states");
        }

        private PlaceBound bound(String place) {
            Map<Kind, List<Integer>> here = netPlaces.getOrDefault(place, Map.of());
            List<TokenBound> kinds = new ArrayList<>();
            here.forEach((kind, places) -> kinds.add(bound(place, kind, places)));
            boolean isBounded = kinds.stream().allMatch(kind -> kind.most().isPresent());
            List<Integer> all = here.values().stream().flatMap(List::stream).toList();
            return new PlaceBound(place, isBounded ? OptionalInt.of(most(all)) : OptionalInt.empty(), kinds);
        }

        private int most(List<Integer> places) {
            ReachabilityGraph graph = facts.graph();
            return IntStream.range(0, graph.states())
                    .map(state -> {
                        int[] marking = graph.marking(state);
                        return places.stream().mapToInt(place -> marking[place]).sum();
                    })
                    .max()
                    .orElse(0);
        }

        private TokenBound bound(String place, Kind kind, List<Integer> places) {
            if (kind == Kind.GENERIC && facts.gathering().contains(place)) {
                return new TokenBound(kind, OptionalInt.empty(), 0, "they gather", List.of());
            }
            int most = most(places);
            int of = kind == Kind.ROBOT ? net.request().robots().size() : 0;
            Optional<MarkingBound> invariant = places.size() != 1 || most == 0
                    ? Optional.empty()
                    : structure.bound(places.get(0)).filter(bound -> bound.mostTokens(places.get(0)) == most);
            if (invariant.isPresent()) {
                IntegerVector weights = invariant.get().weights();
                Set<String> others = others(weights, place);
                return new TokenBound(
                        kind,
                        OptionalInt.of(most),
                        of,
                        others.size() > MOST_NAMED && most == of
                                ? "the team has no more"
                                : sum(weights, others)
                                        + (invariant.get().constant() ? " is always " : " is never more than ")
                                        + invariant.get().most(),
                        List.copyOf(others));
            }
            return new TokenBound(
                    kind,
                    OptionalInt.of(most),
                    of,
                    most == 0
                            ? ""
                            : most == of
                                    ? "the team has no more"
                                    : "no state of " + facts.graph().states() + " has more",
                    List.of());
        }

        private Set<String> others(IntegerVector weights, String place) {
            Set<String> others = new LinkedHashSet<>();
            weights.support().stream()
                    .mapToObj(net::place)
                    .filter(other ->
                            other.role() == Role.TOKEN && !other.planPlace().equals(place))
                    .forEach(other -> others.add(other.planPlace()));
            return others;
        }

        private String sum(IntegerVector weights, Set<String> others) {
            return others.size() > MOST_NAMED
                    ? "with the tokens in " + others.size() + " other places it"
                    : weights.words(this::netWord);
        }

        private String netWord(int netPlace) {
            PlanNetPlace place = net.place(netPlace);
            return place.planPlace().isEmpty()
                    ? net.net().placeName(netPlace)
                    : words.place(place.planPlace()) + (place.token().isEmpty() ? "" : " (" + place.token() + ")");
        }
    }

    /** The bound of a place; empty where none is known. */
    public Optional<PlaceBound> of(String place) {
        return places.stream().filter(bound -> bound.place().equals(place)).findFirst();
    }
}
