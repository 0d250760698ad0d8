package org.sami.dreamm.compare;

import java.util.Objects;
import java.util.Set;

/**
 * One thing in which two versions of a plan differ.
 *
 * @param text one sentence without a full stop
 * @param elements ids of the vertices and edges that it is about; none where it is about the plan as a whole
 */
public record Difference(String text, Set<String> elements) {
    public Difference {
        Objects.requireNonNull(text, "text");
        elements = Set.copyOf(elements);
    }

    @Override
    public String toString() {
        return text;
    }
}
