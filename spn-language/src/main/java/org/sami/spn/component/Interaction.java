package org.sami.spn.component;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.sami.spn.value.ValueType;

/**
 * What the operator is shown or asked, as far as the choice of components looks at it.
 *
 * @param values the types of the values by name, in order; at least one
 * @param wanted the choices of the interaction's markups
 */
public record Interaction(Purpose purpose, Map<String, ValueType> values, List<MarkupOption> wanted) {
    public Interaction {
        Objects.requireNonNull(purpose, "purpose");
        values = Collections.unmodifiableMap(new LinkedHashMap<>(values));
        wanted = List.copyOf(wanted);
        if (values.isEmpty()) {
            throw new IllegalArgumentException("An interaction without values");
        }
    }
}
