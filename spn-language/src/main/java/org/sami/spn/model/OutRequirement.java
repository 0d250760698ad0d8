package org.sami.spn.model;

import java.util.Objects;

/**
 * What a firing does with the tokens of the pool for one out edge.
 *
 * @param n how many tokens, oldest first; {@link #ALL} for all
 * @param task a task's name or a task class, with kind TASK; else empty text
 */
public record OutRequirement(TokenKind kind, int n, Action action, String task) {
    /** The quantity "all". */
    public static final int ALL = -1;

    public OutRequirement {
        Objects.requireNonNull(kind, "kind");
        Objects.requireNonNull(action, "action");
        Objects.requireNonNull(task, "task");
        if (n < ALL) {
            throw new IllegalArgumentException("A quantity is not negative: " + n);
        }
    }

    /** Entry by nobody. */
    public static OutRequirement unconditional() {
        return new OutRequirement(TokenKind.UNCONDITIONAL, ALL, Action.ADD, "");
    }

    /** A requirement on a kind other than TASK. */
    public static OutRequirement of(Action action, int n, TokenKind kind) {
        return new OutRequirement(kind, n, action, "");
    }

    /** Whether the quantity is "all". */
    public boolean takesAll() {
        return n == ALL;
    }
}
