package org.sami.ui.table;

import java.util.Objects;
import java.util.Optional;
import java.util.function.Function;
import javax.swing.Icon;
import org.sami.palette.SemanticColor;

/**
 * A column of a {@link RowTable}.
 *
 * @param width in logical pixels; 0 = what is left
 * @param right whether its text stands at the right, as numbers do
 * @param text what stands in it
 * @param color of the text
 * @param icon before the text
 * @param spare whether it is left out where the table is too narrow for all columns
 * @param last whether it is left out only after all other spare columns
 * @param cutInside whether a text that does not fit into one line keeps its beginning and its end
 */
public record RowColumn<R>(
        String title,
        int width,
        boolean right,
        Function<R, String> text,
        Function<R, SemanticColor> color,
        Function<R, Optional<Icon>> icon,
        boolean spare,
        boolean last,
        boolean cutInside) {
    public RowColumn {
        Objects.requireNonNull(title, "title");
        Objects.requireNonNull(text, "text");
        Objects.requireNonNull(color, "color");
        Objects.requireNonNull(icon, "icon");
    }

    /** Words. */
    public static <R> RowColumn<R> words(String title, int width, Function<R, String> text) {
        return new RowColumn<>(
                title, width, false, text, row -> SemanticColor.TEXT, row -> Optional.empty(), false, false, false);
    }

    /** A number with its unit. */
    public static <R> RowColumn<R> number(String title, int width, Function<R, String> text) {
        return new RowColumn<>(
                title, width, true, text, row -> SemanticColor.TEXT, row -> Optional.empty(), false, false, false);
    }

    /** The same in colours that say something. */
    public RowColumn<R> colored(Function<R, SemanticColor> by) {
        return new RowColumn<>(title, width, right, text, by, icon, spare, last, cutInside);
    }

    /** The same with icons. */
    public RowColumn<R> withIcon(Function<R, Optional<Icon>> by) {
        return new RowColumn<>(title, width, right, text, color, by, spare, last, cutInside);
    }

    /** The same, left out where the table is too narrow for all columns; of several the last one first. */
    public RowColumn<R> asSpare() {
        return new RowColumn<>(title, width, right, text, color, icon, true, false, cutInside);
    }

    /** The same, left out where the table is too narrow even without all other spare columns. */
    public RowColumn<R> asLastSpare() {
        return new RowColumn<>(title, width, right, text, color, icon, true, true, cutInside);
    }

    /** The same for names that may differ at their ends only, such as addresses: where one does not fit, letters within it are left out. */
    public RowColumn<R> keepingEnds() {
        return new RowColumn<>(title, width, right, text, color, icon, spare, last, true);
    }
}
