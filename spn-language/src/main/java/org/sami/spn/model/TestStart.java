package org.sami.spn.model;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import org.sami.spn.value.Value;

/**
 * The marking from which a test case starts instead of the plan's start place.
 *
 * @param values answers to what the plan asks at its start, by {@code eventId.field} or the name of a variable; values not given have
 *     its default
 */
public record TestStart(StartMarking marking, Map<String, Value> values) {
    public TestStart {
        Objects.requireNonNull(marking, "marking");
        values = Collections.unmodifiableMap(new LinkedHashMap<>(values));
    }
}
