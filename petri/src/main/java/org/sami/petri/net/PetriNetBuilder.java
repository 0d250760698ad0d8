package org.sami.petri.net;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Collects the nodes and arcs of a {@link PetriNet}. What makes no sense is refused at once by an {@link IllegalArgumentException} that names it: a second node
 * with an id, a node that is not there, a number of tokens below 0, a weight below 1, weights of parallel arcs that sum up to more than
 * {@link Integer#MAX_VALUE}. Parallel arcs count as one with the sum of their weights; of parallel inhibitor arcs the smallest weight counts. For one thread.
 */
public final class PetriNetBuilder {
    private final String name;
    private final Side places = new Side("place");
    private final Side transitions = new Side("transition");
    private final List<Integer> tokens = new ArrayList<>();
    private final ArcRows consumed = new ArcRows();
    private final ArcRows produced = new ArcRows();
    private final ArcRows inhibitors = new ArcRows();
    private final ArcRows resets = new ArcRows();

    /** An empty net with a name for people. */
    public PetriNetBuilder(String name) {
        this.name = name;
    }

    /** Adds a place that is named by its id; returns its number. */
    public int place(String id, int initial) {
        return place(id, id, initial);
    }

    /** Adds a place; returns its number. */
    public int place(String id, String placeName, int initial) {
        if (initial < 0) {
            throw new IllegalArgumentException("place " + id + " cannot have " + initial + " tokens");
        }
        int number = places.add(id, placeName);
        tokens.add(initial);
        return number;
    }

    /** Adds a transition that is named by its id; returns its number. */
    public int transition(String id) {
        return transition(id, id);
    }

    /** Adds a transition; returns its number. */
    public int transition(String id, String transitionName) {
        return transitions.add(id, transitionName);
    }

    /** Adds an arc by which a transition consumes tokens of a place. */
    public PetriNetBuilder consume(int transition, int place, int weight) {
        return add(consumed, "arc", transition, place, weight);
    }

    /** Adds an arc by which a transition produces tokens in a place. */
    public PetriNetBuilder produce(int transition, int place, int weight) {
        return add(produced, "arc", transition, place, weight);
    }

    /** Adds an inhibitor arc: the transition is disabled while the place has {@code weight} or more tokens. */
    public PetriNetBuilder inhibit(int transition, int place, int weight) {
        return add(inhibitors, "inhibitor arc", transition, place, weight);
    }

    /** Adds a reset arc: the transition empties the place. */
    public PetriNetBuilder reset(int transition, int place) {
        return add(resets, "reset arc", transition, place, 1);
    }

    /** Adds a transition with arcs of weight 1 from and to places that are there; returns its number. */
    public int move(String id, List<String> from, List<String> to) {
        int transition = transition(id);
        from.forEach(place -> consume(transition, placeNumber(place), 1));
        to.forEach(place -> produce(transition, placeNumber(place), 1));
        return transition;
    }

    /** The number of a place; refuses an id that no place has. */
    public int placeNumber(String id) {
        return places.number(id);
    }

    /** The number of a transition; refuses an id that no transition has. */
    public int transitionNumber(String id) {
        return transitions.number(id);
    }

    public boolean hasPlace(String id) {
        return places.numbers.containsKey(id);
    }

    public boolean hasTransition(String id) {
        return transitions.numbers.containsKey(id);
    }

    /** The net of what was added so far. */
    public PetriNet build() {
        int rows = transitions.ids.size();
        return new PetriNet(
                name,
                places.nodes(),
                transitions.nodes(),
                tokens.stream().mapToInt(Integer::intValue).toArray(),
                consumed.table(rows, PetriNetBuilder::sum, this::words),
                produced.table(rows, PetriNetBuilder::sum, this::words),
                inhibitors.table(rows, Math::min, this::words),
                resets.table(rows, Math::min, this::words));
    }

    private PetriNetBuilder add(ArcRows arcs, String kind, int transition, int place, int weight) {
        transitions.check(transition);
        places.check(place);
        if (weight < 1) {
            throw new IllegalArgumentException(
                    kind + " between " + words(transition, place) + " cannot have the weight " + weight);
        }
        arcs.add(transition, place, weight);
        return this;
    }

    private String words(int transition, int place) {
        return "transition " + transitions.ids.get(transition) + " and place " + places.ids.get(place);
    }

    private static long sum(long first, long second) {
        return first + second;
    }

    /** The nodes of one side of the net. */
    private static final class Side {
        private final String kind;
        private final List<String> ids = new ArrayList<>();
        private final List<String> names = new ArrayList<>();
        private final Map<String, Integer> numbers = new HashMap<>();

        Side(String kind) {
            this.kind = kind;
        }

        int add(String id, String name) {
            int number = ids.size();
            if (numbers.putIfAbsent(id, number) != null) {
                throw new IllegalArgumentException("there is a " + kind + " with the id " + id + " already");
            }
            ids.add(id);
            names.add(name);
            return number;
        }

        int number(String id) {
            Integer number = numbers.get(id);
            if (number == null) {
                throw new IllegalArgumentException("there is no " + kind + " with the id " + id);
            }
            return number;
        }

        void check(int number) {
            if (number < 0 || number >= ids.size()) {
                throw new IllegalArgumentException("there is no " + kind + " with the number " + number);
            }
        }

        PetriNet.Nodes nodes() {
            return new PetriNet.Nodes(List.copyOf(ids), List.copyOf(names), Map.copyOf(numbers));
        }
    }
}
