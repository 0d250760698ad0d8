package org.sami.ui.value;

import java.util.Locale;
import java.util.Objects;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.FieldType;

/**
 * What an editor is for: one value, its field and its description.
 *
 * @param path where the value belongs, its parts divided by dots, such as {@code boatId.server}; names the components
 * @param label what is written before the field
 * @param unit the unit in words ("m", "m/s"), empty text where the type says it all
 * @param help one sentence, shown as a tooltip; may be empty text
 */
public record ValueField(String path, String label, ValueType type, String unit, String help) {
    public ValueField {
        Objects.requireNonNull(path, "path");
        Objects.requireNonNull(label, "label");
        Objects.requireNonNull(type, "type");
        Objects.requireNonNull(unit, "unit");
        Objects.requireNonNull(help, "help");
    }

    /** A field without unit and help, labelled by its path. */
    public static ValueField of(String path, ValueType type) {
        return new ValueField(path, words(path), type, "", "");
    }

    /** The field of an event, task class or markup. */
    public static ValueField of(FieldType field) {
        return new ValueField(field.name(), words(field.name()), field.type(), field.unit(), field.help());
    }

    /** What an item of a question asks. */
    public static ValueField of(Question.Item item) {
        return new ValueField(item.key(), words(item.key()), item.type(), item.unit(), item.help());
    }

    /** A part of this value, such as the field of a record or an element of a list. */
    public ValueField part(String name, String label, ValueType partType) {
        return new ValueField(path + "." + name, label, partType, "", "");
    }

    /** The same place with another type. */
    public ValueField as(ValueType other) {
        return new ValueField(path, label, other, unit, help);
    }

    /** The name of a component of this field, such as {@code value-boat-id-server-text}: lower case, parts divided by hyphens. */
    public String componentName(String part) {
        return kebab("value-" + path + (part.isEmpty() ? "" : "-" + part));
    }

    private static String kebab(String text) {
        return text.replaceAll("([a-z0-9])([A-Z])", "$1-$2")
                .toLowerCase(Locale.ROOT)
                .replaceAll("[^a-z0-9]+", "-")
                .replaceAll("-$", "");
    }

    /** The last part of a name as words for people: {@code event.startLocation} becomes {@code Start location}. */
    public static String words(String name) {
        String last = name.substring(name.lastIndexOf('.') + 1).replaceFirst("^@", "");
        String spaced = last.replaceAll("([a-z0-9])([A-Z])", "$1 $2")
                .replaceAll("[_-]+", " ")
                .strip();
        if (spaced.isEmpty()) {
            return name;
        }
        String lower = spaced.substring(1).replaceAll("(?<= )([A-Z])(?=[a-z])", "\0$1");
        StringBuilder text = new StringBuilder(spaced.substring(0, 1).toUpperCase(Locale.ROOT));
        for (int i = 0; i < lower.length(); i++) {
            if (lower.charAt(i) == '\0') {
                i++;
                text.append(Character.toLowerCase(lower.charAt(i)));
            } else {
                text.append(lower.charAt(i));
            }
        }
        return text.toString();
    }
}
