package org.sami.spn.plannet;

import java.util.Collections;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;

/**
 * A marking of the net in the words of the plan.
 *
 * @param tokens how many copies of each token stand in each place; places without any are left out
 * @param nobody the places that are visited by nobody
 * @param running whether the mission runs
 */
public record PlanMarking(SortedMap<String, SortedMap<String, Integer>> tokens, Set<String> nobody, boolean running) {
    public PlanMarking {
        SortedMap<String, SortedMap<String, Integer>> copy = new TreeMap<>();
        tokens.forEach((place, here) -> copy.put(place, Collections.unmodifiableSortedMap(new TreeMap<>(here))));
        tokens = Collections.unmodifiableSortedMap(copy);
        nobody = Collections.unmodifiableSet(new TreeSet<>(nobody));
    }

    /** How many copies of a token stand in a place. */
    public int count(String place, String token) {
        return tokens.getOrDefault(place, Collections.emptySortedMap()).getOrDefault(token, 0);
    }

    /** It in words, such as {@code execute: robot-1 robot-2; finished: 2 generic}. */
    public String words() {
        StringBuilder words = new StringBuilder();
        for (Map.Entry<String, SortedMap<String, Integer>> place : tokens.entrySet()) {
            words.append(words.isEmpty() ? "" : "; ").append(place.getKey()).append(':');
            place.getValue()
                    .forEach((token, count) -> words.append(' ')
                            .append(count == 1 ? "" : count + " ")
                            .append(token));
        }
        return words.isEmpty() ? "no token anywhere" : words.toString();
    }
}
