package org.sami.dreamm.tree;

import java.util.Objects;

/**
 * Something that was found.
 *
 * @param plan id of the plan in which it is; empty text where it is the project itself
 * @param element id of the vertex or edge that shows it; empty text where none does
 * @param title what it is
 * @param detail where, and what of it was found
 */
record Hit(String plan, String element, String title, String detail) {
    Hit {
        Objects.requireNonNull(plan, "plan");
        Objects.requireNonNull(element, "element");
        Objects.requireNonNull(title, "title");
        Objects.requireNonNull(detail, "detail");
    }
}
