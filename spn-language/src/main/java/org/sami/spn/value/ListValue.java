package org.sami.spn.value;

import java.util.List;

/** A list of values of one type, in order. */
public record ListValue(List<Value> items) implements Value {
    public ListValue {
        items = List.copyOf(items);
    }
}
