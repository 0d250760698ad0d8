package org.sami.spn.sequence;

import java.util.List;
import java.util.Objects;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Plan;
import org.sami.spn.model.WaitFor;
import org.sami.spn.vocabulary.TokenNeed;

/** What comes with an event that is added to a plan (thesis 5.1.1). */
public sealed interface Sequence {
    /** Id of the flexible sequence of every event that has one. */
    String USUAL = "usual";

    /** Id of the choice to add an event and nothing else. */
    String ALONE = "alone";

    /** The event type that it belongs to. */
    String event();

    /** Its id, unique among those of its event. */
    String id();

    /** A few words for people. */
    String name();

    /** A sentence for the author on what it makes. */
    String help();

    /** Whether it draws every vertex and edge itself, so that requirements on its edges are not computed. */
    default boolean isManual() {
        return false;
    }

    /**
     * A flexible sequence of an output event.
     *
     * @param tokens what must enter the place for the event to be of use
     * @param inputs input events that lead out of the place, a transition each
     * @param wires fields that are read from what reaches the place although the event's type does not require them
     */
    record OfOutput(String event, String help, TokenNeed tokens, List<String> inputs, List<String> wires)
            implements Sequence {
        public OfOutput {
            Objects.requireNonNull(event, "event");
            Objects.requireNonNull(help, "help");
            Objects.requireNonNull(tokens, "tokens");
            inputs = List.copyOf(inputs);
            wires = List.copyOf(wires);
        }

        @Override
        public String id() {
            return USUAL;
        }

        @Override
        public String name() {
            return "With its usual answers";
        }
    }

    /**
     * A flexible sequence of an input event.
     *
     * @param outputs output events that lead out of the transition, a place each
     * @param in least requirements on edges into the transition
     * @param out least requirements on edges out of the transition
     * @param waitFor how the transition waits, where it has no other input event
     * @param movesGeneric whether the generic token goes on as well; answers that arrive robot by robot leave it to the last
     */
    record OfInput(
            String event,
            String help,
            List<String> outputs,
            List<InRequirement> in,
            List<OutRequirement> out,
            WaitFor waitFor,
            boolean movesGeneric)
            implements Sequence {
        public OfInput {
            Objects.requireNonNull(event, "event");
            Objects.requireNonNull(help, "help");
            outputs = List.copyOf(outputs);
            in = List.copyOf(in);
            out = List.copyOf(out);
            Objects.requireNonNull(waitFor, "waitFor");
        }

        @Override
        public String id() {
            return USUAL;
        }

        @Override
        public String name() {
            return "With what usually follows";
        }
    }

    /**
     * A flexible sequence whose answers come robot by robot, with what the author wants of that.
     *
     * @param of the sequence as its domain says it
     */
    record Gathered(Sequence of, Gathering gathering) implements Sequence {
        public Gathered {
            Objects.requireNonNull(of, "of");
            Objects.requireNonNull(gathering, "gathering");
        }

        @Override
        public String event() {
            return of.event();
        }

        @Override
        public String id() {
            return gathering.id();
        }

        @Override
        public String name() {
            return gathering.label();
        }

        @Override
        public String help() {
            return gathering.help();
        }
    }

    /**
     * A manual sequence: every vertex, event, edge and requirement. Its edges are locked.
     *
     * @param part what is drawn; its name and description are the sequence's
     * @param anchor id of the vertex in it that holds the event
     * @param pattern whether it is offered as a pattern around a selected vertex as well
     */
    record Manual(String event, Plan part, String anchor, boolean pattern) implements Sequence {
        public Manual {
            Objects.requireNonNull(event, "event");
            Objects.requireNonNull(part, "part");
            Objects.requireNonNull(anchor, "anchor");
        }

        @Override
        public String id() {
            return part.id();
        }

        @Override
        public String name() {
            return part.title();
        }

        @Override
        public String help() {
            return part.description();
        }

        @Override
        public boolean isManual() {
            return true;
        }
    }
}
