package org.sami.crw.manipulation;

import java.util.Objects;

/**
 * What becomes of an automatic change.
 *
 * @param untilMillis when it is made, on the policy's clock, where it waits; else 0
 * @param why in words; empty where it is made now
 */
public record Ruling(Kind kind, long untilMillis, String why) {
    static final Ruling NOW = new Ruling(Kind.NOW, 0, "");

    /** What becomes of it. */
    public enum Kind {
        /** It is made now. */
        NOW,
        /** It is made later, unless a newer one of the same event takes its place. */
        LATER,
        /** It is not made. */
        DROPPED
    }

    public Ruling {
        Objects.requireNonNull(kind, "kind");
        Objects.requireNonNull(why, "why");
    }
}
