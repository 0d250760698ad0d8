package org.sami.ui.value;

import java.util.Objects;
import java.util.Optional;
import org.sami.spn.value.Value;

/** What a field holds now: a value, or the reason why there is none yet. */
public sealed interface Entry {
    /** A value of the field's type. */
    record Given(Value given) implements Entry {
        public Given {
            Objects.requireNonNull(given, "given");
        }
    }

    /**
     * No value yet.
     *
     * @param why one line that says what to do
     * @param wrong whether something was entered that is no value; false = nothing was entered
     */
    record Missing(String why, boolean wrong) implements Entry {
        public Missing {
            Objects.requireNonNull(why, "why");
        }
    }

    /** An entry with a value. */
    static Entry of(Value value) {
        return new Given(value);
    }

    /** Nothing was entered. */
    static Entry nothing(String reason) {
        return new Missing(reason, false);
    }

    /** What was entered is no value. */
    static Entry wrong(String reason) {
        return new Missing(reason, true);
    }

    /** The value, if there is one. */
    default Optional<Value> value() {
        return this instanceof Given one ? Optional.of(one.given()) : Optional.empty();
    }

    /** Why there is no value; empty where there is one. */
    default Optional<String> reason() {
        return this instanceof Missing none ? Optional.of(none.why()) : Optional.empty();
    }
}
