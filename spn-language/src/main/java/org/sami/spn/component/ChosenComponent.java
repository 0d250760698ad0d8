package org.sami.spn.component;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.sami.spn.value.ValueType;

/** With what a value is shown or asked for: what Algorithms 4 to 6 of thesis 5.2.4 construct. */
public sealed interface ChosenComponent {
    /** The score of {@link Warning}. */
    int NONE = -1;

    /** How many choices of markups it acts on, of a whole the least of its parts; {@link #NONE} where there is none. */
    int score();

    /** One component that can do it, with the fewest widgets for that (Algorithm 5). */
    record Direct(ComponentType component, List<WidgetType> widgets, ValueType type, List<MarkupOption> actsOn)
            implements ChosenComponent {
        public Direct {
            Objects.requireNonNull(component, "component");
            Objects.requireNonNull(type, "type");
            widgets = List.copyOf(widgets);
            actsOn = List.copyOf(actsOn);
        }

        @Override
        public int score() {
            return actsOn.size();
        }
    }

    /** A component for each element of a list, as many as are needed. */
    record Repeated(ChosenComponent element) implements ChosenComponent {
        @Override
        public int score() {
            return element.score();
        }
    }

    /** A component for the key and one for the value of each entry of a map. */
    record Entries(ChosenComponent key, ChosenComponent value) implements ChosenComponent {
        @Override
        public int score() {
            return Math.min(key.score(), value.score());
        }
    }

    /** A component for each of several named values: the fields of a record (Algorithm 6), or all that one decision asks. */
    record Form(Map<String, ChosenComponent> fields) implements ChosenComponent {
        public Form {
            fields = Collections.unmodifiableMap(new LinkedHashMap<>(fields));
            if (fields.isEmpty()) {
                throw new IllegalArgumentException("A form without fields");
            }
        }

        @Override
        public int score() {
            return fields.values().stream()
                    .mapToInt(ChosenComponent::score)
                    .min()
                    .orElseThrow();
        }
    }

    /**
     * No collection of components can do it; a text that says so is shown in their place.
     *
     * @param reason one sentence for the operator
     */
    record Warning(String reason) implements ChosenComponent {
        public Warning {
            Objects.requireNonNull(reason, "reason");
        }

        @Override
        public int score() {
            return NONE;
        }
    }
}
