package org.sami.spn.plannet;

import java.util.List;
import java.util.Objects;

/**
 * What a transition of the net stands for: one case of a firing.
 *
 * @param transition id of the plan's transition; empty where the engine itself does it
 * @param named robots, and tasks behind {@code #}, that the input events name
 * @param ends whether the mission is over then
 */
public record PlanNetFiring(String transition, List<String> named, List<PlanNetMove> moves, boolean ends) {
    public PlanNetFiring {
        Objects.requireNonNull(transition, "transition");
        named = List.copyOf(named);
        moves = List.copyOf(moves);
    }

    /** It in words, such as {@code arrive(robot-1): robot-1 execute → finished}. */
    public String words() {
        StringBuilder words = new StringBuilder(transition.isEmpty() ? "the mission ends" : transition);
        if (!named.isEmpty()) {
            words.append('(').append(String.join(", ", named)).append(')');
        }
        String separator = ": ";
        for (PlanNetMove move : moves) {
            words.append(separator).append(move.token());
            if (!move.from().isEmpty()) {
                words.append(' ').append(move.from());
            }
            words.append(" → ").append(move.to().isEmpty() ? "consumed" : move.to());
            separator = ", ";
        }
        return words.toString();
    }
}
