package org.sami.spn.vocabulary;

import java.util.Objects;
import java.util.Optional;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;

/**
 * A field of an event, task class or markup.
 *
 * @param unit the unit in words ("m", "m/s", "deg"), empty text where the type says it all
 * @param required whether an event specification must give it by some source
 * @param defaultValue used where the field is not required and not given
 * @param help a sentence for the plan's author
 * @param geography what a geographic value here means to the checks of plans
 * @param limits which values of the type the checks of plans let pass
 */
public record FieldType(
        String name,
        ValueType type,
        String unit,
        boolean required,
        Optional<Value> defaultValue,
        String help,
        Optional<GeographyMark> geography,
        FieldLimits limits) {
    public FieldType {
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(type, "type");
        Objects.requireNonNull(unit, "unit");
        Objects.requireNonNull(defaultValue, "defaultValue");
        Objects.requireNonNull(help, "help");
        Objects.requireNonNull(geography, "geography");
        Objects.requireNonNull(limits, "limits");
    }

    /** A field that means nothing special to the checks. */
    public FieldType(
            String name, ValueType type, String unit, boolean required, Optional<Value> defaultValue, String help) {
        this(name, type, unit, required, defaultValue, help, Optional.empty(), FieldLimits.NONE);
    }
}
