package org.sami.spn.wizard;

import java.util.Objects;
import java.util.Optional;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Plan;
import org.sami.spn.vocabulary.Direction;
import org.sami.spn.vocabulary.EventType;

/** Where an event is added. */
public sealed interface EventTarget {
    /** On a vertex that is there: output events on places, input events on transitions. */
    record OnVertex(String vertex) implements EventTarget {
        public OnVertex {
            Objects.requireNonNull(vertex, "vertex");
        }
    }

    /**
     * On a new vertex in free space.
     *
     * @param at where it is drawn; empty leaves that to an automatic layout
     */
    record Free(Optional<LayoutPoint> at) implements EventTarget {
        public Free {
            Objects.requireNonNull(at, "at");
        }
    }

    /** On a new vertex behind one that is there; between two of a kind comes a blank one of the other. */
    record Behind(String vertex) implements EventTarget {
        public Behind {
            Objects.requireNonNull(vertex, "vertex");
        }
    }

    /** Why an event of a type cannot be added here, in one sentence; empty where it can. */
    default Optional<String> refusal(Plan plan, EventType type) {
        String vertex =
                this instanceof OnVertex on ? on.vertex() : this instanceof Behind behind ? behind.vertex() : "";
        if (vertex.isEmpty()) {
            return Optional.empty();
        }
        boolean place = plan.place(vertex).isPresent();
        if (!place && plan.transition(vertex).isEmpty()) {
            return Optional.of("The plan \"" + plan.id() + "\" has no vertex " + vertex);
        }
        boolean output = type.direction() == Direction.OUTPUT;
        if (this instanceof OnVertex && output != place) {
            return Optional.of(type.label() + " is an " + (output ? "output" : "input") + " event: it stands on "
                    + (output ? "places" : "transitions") + ", and " + vertex + " is a "
                    + (place ? "place" : "transition"));
        }
        return Optional.empty();
    }
}
