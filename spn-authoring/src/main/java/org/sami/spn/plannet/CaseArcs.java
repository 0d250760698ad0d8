package org.sami.spn.plannet;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.sami.petri.net.PetriNetBuilder;

/** The arcs of one transition of the net while it is put together: conditions and changes of places, each by its number. */
final class CaseArcs {
    private final Map<Integer, Integer> least = new TreeMap<>();
    private final Map<Integer, Integer> below = new TreeMap<>();
    private final Map<Integer, Integer> minus = new TreeMap<>();
    private final Map<Integer, Integer> plus = new TreeMap<>();
    private final Set<Integer> emptied = new TreeSet<>();

    CaseArcs copy() {
        CaseArcs copy = new CaseArcs();
        copy.join(this);
        return copy;
    }

    /** Takes over the conditions and changes of another one. */
    void join(CaseArcs other) {
        other.least.forEach(this::atLeast);
        other.below.forEach(this::below);
        other.minus.forEach(this::remove);
        other.plus.forEach(this::add);
        emptied.addAll(other.emptied);
    }

    /** Takes over what another one changes, not what it asks for. */
    void joinChanges(CaseArcs other) {
        other.minus.forEach(this::remove);
        other.plus.forEach(this::add);
        emptied.addAll(other.emptied);
    }

    /** The place has so many tokens or more. */
    void atLeast(int place, int tokens) {
        if (tokens > 0) {
            least.merge(place, tokens, Math::max);
        }
    }

    /** The place has fewer tokens. */
    void below(int place, int tokens) {
        below.merge(place, tokens, Math::min);
    }

    void remove(int place, int tokens) {
        if (tokens > 0) {
            minus.merge(place, tokens, Integer::sum);
        }
    }

    void add(int place, int tokens) {
        if (tokens > 0) {
            plus.merge(place, tokens, Integer::sum);
        }
    }

    /** The place is empty before tokens are added. */
    void empty(int place) {
        emptied.add(place);
    }

    /** The place has one token afterwards. */
    void set(int place) {
        emptied.add(place);
        plus.put(place, 1);
    }

    /** Empty afterwards, whatever was to be added before. */
    void clear(int place) {
        emptied.add(place);
        plus.remove(place);
    }

    /** Nothing is added to the place after all. */
    void cancel(int place) {
        plus.remove(place);
    }

    /** How many tokens are added to a place. */
    int added(int place) {
        return plus.getOrDefault(place, 0);
    }

    boolean needs(int place) {
        return least.containsKey(place) || minus.containsKey(place);
    }

    boolean adds(int place) {
        return plus.containsKey(place);
    }

    /** Whether no marking fulfils all conditions. */
    boolean isImpossible() {
        return below.entrySet().stream()
                .anyMatch(e ->
                        Math.max(least.getOrDefault(e.getKey(), 0), minus.getOrDefault(e.getKey(), 0)) >= e.getValue());
    }

    void put(PetriNetBuilder net, int transition) {
        Set<Integer> needed = new TreeSet<>(least.keySet());
        needed.addAll(minus.keySet());
        Map<Integer, Integer> produced = new TreeMap<>(plus);
        for (int place : needed) {
            int removed = minus.getOrDefault(place, 0);
            int consumed = Math.max(least.getOrDefault(place, 0), removed);
            net.consume(transition, place, consumed);
            if (consumed > removed && !emptied.contains(place)) {
                produced.merge(place, consumed - removed, Integer::sum);
            }
        }
        below.forEach((place, tokens) -> net.inhibit(transition, place, tokens));
        emptied.forEach(place -> net.reset(transition, place));
        produced.forEach((place, tokens) -> net.produce(transition, place, tokens));
    }

    /** Equal keys: equal arcs. It changes with them. */
    Object key() {
        return List.of(least, below, minus, plus, emptied);
    }
}
