package org.sami.crw.report;

import java.util.Objects;

/**
 * A point of the plan that is none of the locations to be visited.
 *
 * @param boat whose place it is; empty text where it is nobody's in particular
 */
public record MapSpot(Kind kind, String boat, MapPoint at) {
    /** What a point is for. */
    public enum Kind {
        /** A boat's place where boats gathered. */
        ASSEMBLY("assembly place"),
        /** The plan speaks of it otherwise: where to go to, to gather around, to keep to. */
        PLAN("point of the plan");

        private final String words;

        Kind(String words) {
            this.words = words;
        }

        /** As people call it. */
        public String words() {
            return words;
        }
    }

    public MapSpot {
        Objects.requireNonNull(kind, "kind");
        Objects.requireNonNull(boat, "boat");
        Objects.requireNonNull(at, "at");
    }
}
