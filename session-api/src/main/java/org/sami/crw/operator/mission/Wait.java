package org.sami.crw.operator.mission;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;

/**
 * A place where missions wait, and what they wait for.
 *
 * @param missions number of missions in the same position; there may be many sub-missions of one plan
 * @param plan id of the mission's plan
 * @param place name of the place, or its id without one; empty where no place is marked
 * @param tokens the tokens there, in words, copies counted; empty for a visit by nobody
 * @param occurrence what lets it go on, in words: input events joined by {@code or}, or why no transition fires
 * @param transitions the transitions out of the place, in the plan's order
 */
public record Wait(
        int missions,
        String plan,
        String place,
        List<String> tokens,
        String occurrence,
        List<BlockedTransition> transitions) {
    /**
     * A transition that cannot fire.
     *
     * @param name its name, or its id where it has none
     * @param reasons why, in sentences; empty where only an event that may come at any time is missing
     */
    public record BlockedTransition(String name, List<String> reasons) {
        public BlockedTransition {
            Objects.requireNonNull(name, "name");
            reasons = List.copyOf(reasons);
        }
    }

    public Wait {
        Objects.requireNonNull(plan, "plan");
        Objects.requireNonNull(place, "place");
        tokens = List.copyOf(tokens);
        Objects.requireNonNull(occurrence, "occurrence");
        transitions = List.copyOf(transitions);
    }

    /** The same for so many missions. */
    public Wait of(int count) {
        return new Wait(count, plan, place, tokens, occurrence, transitions);
    }

    /** In lines for people: the place and who is there, then each transition with its reasons. */
    public List<String> lines() {
        List<String> lines = new ArrayList<>();
        lines.add(where() + " waits for " + occurrence);
        transitions.forEach(transition -> transition
                .reasons()
                .forEach(reason -> lines.add("  '" + transition.name() + "' cannot fire: " + reason)));
        return lines;
    }

    private String where() {
        String of = (missions == 1 ? "" : missions + " missions of ") + "plan " + plan;
        String who = tokens.isEmpty() ? "" : ", " + String.join(", ", tokens);
        return place.isEmpty() ? of : "'" + place + "' (" + of + who + ")";
    }
}
