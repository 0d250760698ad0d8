package org.sami.spn.protocol;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.sami.spn.value.Value;

/** The answer to a {@link Decision}; {@link Question} names the kind that fits. */
public sealed interface Answer {
    /** Yes or no. */
    record YesNo(boolean yes) implements Answer {}

    /** The chosen proxies. */
    record Proxies(List<String> proxies) implements Answer {
        public Proxies {
            proxies = List.copyOf(proxies);
        }
    }

    /** The index of the chosen option, from 0. */
    record Option(int index) implements Answer {}

    /** None of the options. */
    record Rejected() implements Answer {}

    /** Values by field name. */
    record Fields(Map<String, Value> values) implements Answer {
        public Fields {
            Objects.requireNonNull(values, "values");
            values = Collections.unmodifiableMap(new LinkedHashMap<>(values));
        }
    }
}
