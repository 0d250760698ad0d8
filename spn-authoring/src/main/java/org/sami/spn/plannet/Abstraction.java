package org.sami.spn.plannet;

import java.util.Objects;

/**
 * Where a net is not exactly what the engine does.
 *
 * @param where id of a place or transition of the plan; empty where it concerns the whole plan
 * @param text a sentence for people
 */
public record Abstraction(Kind kind, String where, String text) {
    /** On which side of the engine the net is. */
    public enum Kind {
        /** The net can do more: that something never happens is true, that it happens may be false. */
        WIDER,
        /** The net follows only a part: that something happens is true, that it never happens may be false. */
        PARTIAL
    }

    public Abstraction {
        Objects.requireNonNull(kind, "kind");
        Objects.requireNonNull(where, "where");
        Objects.requireNonNull(text, "text");
    }

    /** It with the place or transition that it concerns. */
    public String words() {
        return where.isEmpty() ? text : where + ": " + text;
    }
}
