package org.sami.ui.value;

import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import org.sami.palette.IdentityMark;
import org.sami.spn.value.Value;

/**
 * One thing that can be chosen from a list.
 *
 * @param title what it is called
 * @param detail what else helps to choose, such as a state; may be empty text
 * @param mark by which it is known in map, net and lists
 */
public record ChoiceRow(Value value, String title, String detail, Optional<IdentityMark> mark) {
    public ChoiceRow {
        Objects.requireNonNull(value, "value");
        Objects.requireNonNull(title, "title");
        Objects.requireNonNull(detail, "detail");
        Objects.requireNonNull(mark, "mark");
    }

    /** A row without mark. */
    public ChoiceRow(Value value, String title, String detail) {
        this(value, title, detail, Optional.empty());
    }

    /** Whether a text stands in it, in capital letters or not. */
    boolean contains(String text) {
        return (title + "\n" + detail).toLowerCase(Locale.ROOT).contains(text.toLowerCase(Locale.ROOT));
    }
}
