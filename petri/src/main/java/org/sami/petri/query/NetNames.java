package org.sami.petri.query;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.sami.petri.net.PetriNet;

/** What the names in a query mean: nodes of a net by their ids, or by other words of whoever made the net. Immutable. */
public interface NetNames {
    /** The places whose tokens a name counts together; empty where it names nothing. */
    Optional<List<Integer>> places(String name);

    /** The transitions of a name, of which one is enabled where the name is; empty where it names nothing. */
    Optional<List<Integer>> transitions(String name);

    /** Markings that are ends, so no deadlocks, and that {@code ended} means; empty where there is no such word. */
    Optional<MarkingCondition> end();

    /** Markings in which one thing stands in several places, or twice in one, which {@code duplicated} means; empty where there is no such word. */
    default Optional<MarkingCondition> duplicated() {
        return Optional.empty();
    }

    /** The ids of a net's nodes. */
    static NetNames of(PetriNet net) {
        return new NetNames() {
            @Override
            public Optional<List<Integer>> places(String name) {
                return node(net.place(name));
            }

            @Override
            public Optional<List<Integer>> transitions(String name) {
                return node(net.transition(name));
            }

            @Override
            public Optional<MarkingCondition> end() {
                return Optional.empty();
            }

            private Optional<List<Integer>> node(OptionalInt number) {
                return number.isPresent() ? Optional.of(List.of(number.getAsInt())) : Optional.empty();
            }
        };
    }
}
