package org.sami.spn.model;

import java.util.Objects;
import java.util.Optional;
import org.sami.spn.value.Value;

/** Where the value of a field of an output event comes from (thesis 3.1, Events; 9.3.4 for {@code @task}). */
public sealed interface FieldSource {
    /** Set offline by the plan's author; may be redefined by nobody. */
    record Fixed(Value value) implements FieldSource {
        public Fixed {
            Objects.requireNonNull(value, "value");
        }
    }

    /**
     * Asked of the operator when the mission or instance starts.
     *
     * @param editable false = locked: the default is shown and cannot be changed
     */
    record Asked(Optional<Value> defaultValue, boolean editable) implements FieldSource {
        public Asked {
            Objects.requireNonNull(defaultValue, "defaultValue");
            if (!editable && defaultValue.isEmpty()) {
                throw new IllegalArgumentException("A locked field needs a default");
            }
        }
    }

    /** Read from a variable at entry; the name has its leading {@code @}. */
    record FromVariable(String variable) implements FieldSource {
        public FromVariable {
            Objects.requireNonNull(variable, "variable");
        }
    }

    /** Read from each entering task: the task's field of the same name as the event's field. */
    record FromTask() implements FieldSource {}
}
