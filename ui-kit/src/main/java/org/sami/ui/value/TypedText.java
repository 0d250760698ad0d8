package org.sami.ui.value;

import org.sami.spn.value.Value;

/** Reads values of one type from what the operator types, and writes them. What it writes it reads; immutable, knows no window. */
interface TypedText {
    /** The value of a text, or why it is none. */
    Entry read(String text);

    /** A value of the type as text. */
    String write(Value value);

    /** An example, shown where nothing has been typed. */
    String example();

    /** How many characters a usual text has. */
    int columns();

    /** Whether a text has several lines. */
    default boolean multiline() {
        return false;
    }
}
