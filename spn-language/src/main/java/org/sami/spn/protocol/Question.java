package org.sami.spn.protocol;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;

/** What a {@link Decision} asks. */
public sealed interface Question {
    /** Asks for {@link Answer.YesNo}. */
    record Approve() implements Question {}

    /** Asks for {@link Answer.Proxies}: between min and max of the given ones. */
    record ChooseProxies(List<String> proxies, int min, int max) implements Question {
        public ChooseProxies {
            proxies = List.copyOf(proxies);
        }
    }

    /** Asks for {@link Answer.Option} or {@link Answer.Rejected}. */
    record ChooseOption(List<Value> options) implements Question {
        public ChooseOption {
            options = List.copyOf(options);
        }
    }

    /** Asks for {@link Answer.Fields}: one value per editable item. */
    record FillIn(List<Item> items) implements Question {
        public FillIn {
            items = List.copyOf(items);
        }
    }

    /**
     * One value to give.
     *
     * @param key the key in the answer: a field's name, {@code eventId.field} for parameters, or a variable's name
     * @param editable false = shown with its default and taken from there
     */
    record Item(String key, ValueType type, String unit, Optional<Value> defaultValue, boolean editable, String help) {
        public Item {
            Objects.requireNonNull(key, "key");
            Objects.requireNonNull(type, "type");
            Objects.requireNonNull(unit, "unit");
            Objects.requireNonNull(defaultValue, "defaultValue");
            Objects.requireNonNull(help, "help");
        }
    }
}
