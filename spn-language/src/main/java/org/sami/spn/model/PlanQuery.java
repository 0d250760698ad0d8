package org.sami.spn.model;

import java.util.Objects;

/**
 * A question about what a plan can do, saved with it, which a search of its states answers (thesis, section 4.3.1). What the text means, and whether it means
 * anything, says {@code docs/analysis.md}.
 *
 * @param name unique in the plan
 * @param text such as {@code reachable m(recharge) >= 1 and m(visit) = 0}
 * @param expected the answer that the author expects; another one is a finding
 */
public record PlanQuery(String name, String text, Expected expected) {
    /** An answer. */
    public enum Expected {
        YES,
        NO
    }

    public PlanQuery {
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(text, "text");
        Objects.requireNonNull(expected, "expected");
    }

    /** The same query with another text. */
    public PlanQuery withText(String newText) {
        return new PlanQuery(name, newText, expected);
    }
}
