package org.sami.crw.cli.defaults;

import java.util.Objects;

/**
 * A value that holds where nobody says otherwise.
 *
 * @param subject what it belongs to, such as {@code Boats}
 * @param name in words, or that of the option or field
 * @param value as text; empty where there is none and somebody has to say one
 * @param unit such as {@code m/s}; empty for a count or a word
 * @param meaning what it does, as a sentence
 * @param setBy where it is set: an option, a field of a plan; {@link #NOWHERE}
 */
public record DefaultValue(String subject, String name, String value, String unit, String meaning, String setBy) {
    /** It is a constant of the program. */
    public static final String NOWHERE = "nowhere";

    public DefaultValue {
        Objects.requireNonNull(subject, "subject");
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(value, "value");
        Objects.requireNonNull(unit, "unit");
        Objects.requireNonNull(meaning, "meaning");
        Objects.requireNonNull(setBy, "setBy");
    }

    /** The value with its unit; a dash where there is none. */
    public String valueText() {
        return value.isEmpty() ? "–" : unit.isEmpty() ? value : value + " " + unit;
    }
}
