package org.sami.spn.planspace;

import java.util.List;
import java.util.Objects;
import java.util.OptionalInt;
import java.util.stream.Collectors;

/**
 * How many tokens can be in a place of a plan at once.
 *
 * @param place its id
 * @param most tokens of all kinds together; empty where no number is known to bound them
 * @param kinds one for each kind of tokens that the net of the plan has
 */
public record PlaceBound(String place, OptionalInt most, List<TokenBound> kinds) {
    public PlaceBound {
        Objects.requireNonNull(place, "place");
        Objects.requireNonNull(most, "most");
        kinds = List.copyOf(kinds);
    }

    /** For a sign at the place: how many robots, such as {@code ≤ 2}, or where none can come how many tokens; with ω where tokens gather. */
    public String sign() {
        int robots = kinds.stream()
                .filter(bound -> bound.kind() == TokenBound.Kind.ROBOT)
                .mapToInt(bound -> bound.most().orElse(0))
                .sum();
        if (robots > 0) {
            return "≤ " + robots + (most.isEmpty() ? ", ω" : "");
        }
        return most.isEmpty() ? "ω" : "≤ " + most.getAsInt();
    }

    /** For people: how many of each kind, and why there are no more. */
    public String words() {
        List<TokenBound> some = kinds.stream()
                .filter(bound -> bound.most().isEmpty() || bound.most().getAsInt() > 0)
                .toList();
        return some.isEmpty()
                ? "No token is ever here"
                : some.stream()
                        .map(bound -> bound.words() + (bound.reason().isEmpty() ? "" : ": " + bound.reason()))
                        .collect(Collectors.joining("; "));
    }
}
