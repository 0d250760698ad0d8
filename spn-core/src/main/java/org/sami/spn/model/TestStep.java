package org.sami.spn.model;

import java.util.Map;
import java.util.Objects;
import org.sami.spn.value.Value;

/**
 * One step of a saved test case: something that is done to the mission, or something expected of it.
 *
 * @param kind such as {@code occur}, {@code answer}, {@code interrupt}, {@code advance}, {@code expect-marking},
 *     {@code expect-ended}
 * @param target the event, decision or place that it is about; empty text where the kind says it all
 */
public record TestStep(String kind, String target, Map<String, Value> arguments) {
    public TestStep {
        Objects.requireNonNull(kind, "kind");
        Objects.requireNonNull(target, "target");
        arguments = Map.copyOf(arguments);
    }
}
