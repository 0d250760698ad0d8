package org.sami.spn.wiring;

import java.util.Objects;
import java.util.Optional;

/** Something that a field of an output event can be read from. */
public sealed interface DataSource {
    /** Steps of what has no known distance: first values, what parents give, what nothing before the place writes. */
    int FAR = Integer.MAX_VALUE;

    /** How many transitions fire between the source and the event's place, at least; {@link #FAR} where none has to. */
    int steps();

    /** Whether a value is there when the place is entered, as far as the plan's ways say. */
    boolean reaches();

    /**
     * A field of an answer that is taken on a way to the place.
     *
     * @param event id of the input event
     * @param type name of its type
     * @param field of it
     * @param transition that takes the answer
     * @param variable into which it is written already; empty where reading it declares one
     */
    record AnswerField(String event, String type, String field, String transition, Optional<String> variable, int steps)
            implements DataSource {
        public AnswerField {
            Objects.requireNonNull(event, "event");
            Objects.requireNonNull(type, "type");
            Objects.requireNonNull(field, "field");
            Objects.requireNonNull(transition, "transition");
            Objects.requireNonNull(variable, "variable");
        }

        @Override
        public boolean reaches() {
            return true;
        }
    }

    /** A variable of the field's type, with its leading {@code @}. */
    record Variable(String name, Origin origin, int steps) implements DataSource {
        public Variable {
            Objects.requireNonNull(name, "name");
            Objects.requireNonNull(origin, "origin");
        }

        @Override
        public boolean reaches() {
            return origin != Origin.NOTHING_BEFORE;
        }
    }

    /** The field of the same name of each task that enters. */
    record EnteringTask(String field) implements DataSource {
        public EnteringTask {
            Objects.requireNonNull(field, "field");
        }

        @Override
        public int steps() {
            return 0;
        }

        @Override
        public boolean reaches() {
            return true;
        }
    }

    /** From where a variable has its value. */
    enum Origin {
        /** An event or sub-mission before the place writes it. */
        WRITTEN_BEFORE,
        /** Its declaration says its first value. */
        FIRST_VALUE,
        /** A plan that runs this one brings it. */
        PARENT,
        /** Nothing before the place writes it. */
        NOTHING_BEFORE
    }
}
