package org.sami.spn.drawing.states;

import java.util.List;

/**
 * A reachability graph in words, as it is drawn (thesis, section 4.2.1). Immutable.
 *
 * @param title what was searched
 * @param remark how much of it is shown, and what was left out; a line below the title
 * @param states the first one is the initial one
 * @param arrows the firings between them, at most one between two states in each direction
 */
public record StateGraph(String title, String remark, List<State> states, List<Arrow> arrows) {
    public StateGraph {
        states = List.copyOf(states);
        arrows = List.copyOf(arrows);
        for (Arrow arrow : arrows) {
            if (Math.min(arrow.from(), arrow.to()) < 0 || Math.max(arrow.from(), arrow.to()) >= states.size()) {
                throw new IllegalArgumentException(
                        "an arrow from " + arrow.from() + " to " + arrow.to() + " among " + states.size() + " states");
            }
        }
    }

    /** What is special about a state. */
    public enum Kind {
        /** Something can happen. */
        INNER,
        /** Nothing can happen any more, as it should be. */
        END,
        /** Nothing can happen any more, and it is no end. */
        DEADLOCK,
        /** It was found, and not followed: the budget was used up. */
        NOT_FOLLOWED
    }

    /**
     * A state.
     *
     * @param name short, such as its number
     * @param marked the marked places, each with its tokens
     */
    public record State(String name, List<String> marked, Kind kind) {
        public State {
            marked = List.copyOf(marked);
        }
    }

    /**
     * The firings from one state to another.
     *
     * @param from number of the state
     * @param to number of the state after the firing
     * @param firings what fires, in words: any one of them
     */
    public record Arrow(int from, int to, List<String> firings) {
        public Arrow {
            firings = List.copyOf(firings);
        }

        /** Its words for a drawing: a few of the firings, and how many more there are. */
        public List<String> lines() {
            int most = 3;
            if (firings.size() <= most) {
                return firings;
            }
            return List.of(firings.get(0), firings.get(1), "and " + (firings.size() - 2) + " more");
        }
    }
}
