package org.sami.spn.edit;

import java.util.Objects;

/**
 * One place where something is used.
 *
 * @param plan id of the plan; empty text where it is the project itself
 * @param element id of the vertex, edge, event or sub-mission, or name of the variable or task, in which it is used; empty text where it
 *     stands in none, as in a test case
 * @param where in words, such as {@code field speed}
 */
public record Usage(String plan, String element, String where) {
    public Usage {
        Objects.requireNonNull(plan, "plan");
        Objects.requireNonNull(element, "element");
        Objects.requireNonNull(where, "where");
    }
}
