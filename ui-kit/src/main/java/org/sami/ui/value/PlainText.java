package org.sami.ui.value;

import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/** A text, as it is typed; an empty one is a text too. */
record PlainText() implements TypedText {
    @Override
    public Entry read(String text) {
        return Entry.of(new TextValue(text));
    }

    @Override
    public String write(Value value) {
        return ((TextValue) value).value();
    }

    @Override
    public String example() {
        return "";
    }

    @Override
    public int columns() {
        return 24;
    }
}
