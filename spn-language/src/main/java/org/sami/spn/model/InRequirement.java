package org.sami.spn.model;

import java.util.Objects;

/**
 * A condition on the tokens of one in place.
 *
 * @param n the number of LESS_THAN, AT_LEAST and EXACTLY; 0 with other matches
 * @param task a task's name or a task class, with kind TASK; else empty text
 */
public record InRequirement(TokenKind kind, Match match, int n, String task) {
    public InRequirement {
        Objects.requireNonNull(kind, "kind");
        Objects.requireNonNull(match, "match");
        Objects.requireNonNull(task, "task");
        if (kind == TokenKind.SUB_MISSION_TOKENS) {
            throw new IllegalArgumentException("Sub-mission tokens stand on out edges only");
        }
        if (match == Match.ALL && kind != TokenKind.RELEVANT && kind != TokenKind.UNCONDITIONAL) {
            throw new IllegalArgumentException("Match all goes with relevant tokens only, not with " + kind);
        }
        if (n < 0) {
            throw new IllegalArgumentException("A quantity is not negative: " + n);
        }
    }

    /** No condition: the place joins the pool and is watched. */
    public static InRequirement unconditional() {
        return new InRequirement(TokenKind.UNCONDITIONAL, Match.ALL, 0, "");
    }

    /** A condition on a kind other than TASK. */
    public static InRequirement of(TokenKind kind, Match match, int n) {
        return new InRequirement(kind, match, n, "");
    }

    /** Every relevant token is here. */
    public static InRequirement allRelevant() {
        return new InRequirement(TokenKind.RELEVANT, Match.ALL, 0, "");
    }

    /** Whether nobody of its kind may be there. */
    public boolean asksForNone() {
        return match == Match.ZERO || (match == Match.LESS_THAN && n <= 1) || (match == Match.EXACTLY && n == 0);
    }
}
