package org.sami.spn.phase;

import java.util.List;
import java.util.Objects;

/**
 * One phase as it is shown for certain choices at its branches.
 *
 * @param actors the rows, in the order in which they first act
 * @param boxes the actions, by column and then as the plan has them
 * @param next the phases in which execution goes on, for the box that closes this one; empty where the plan ends here
 */
public record PhaseView(String phase, List<String> actors, List<Box> boxes, List<String> next) {
    public PhaseView {
        Objects.requireNonNull(phase, "phase");
        actors = List.copyOf(actors);
        boxes = List.copyOf(boxes);
        next = List.copyOf(next);
    }

    /**
     * An action in its place. Actions of one column may go on at the same time.
     *
     * @param row index into the actors, from 0
     * @param column from 0, without gaps
     * @param options the branch buttons on it, in the plan's order
     * @param chosen the option whose effect is shown; empty text where there is none
     */
    public record Box(PhaseAction action, int row, int column, List<PhaseAction> options, String chosen) {
        public Box {
            Objects.requireNonNull(action, "action");
            Objects.requireNonNull(chosen, "chosen");
            options = List.copyOf(options);
        }
    }
}
