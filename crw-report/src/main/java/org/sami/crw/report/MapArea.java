package org.sami.crw.report;

import java.util.List;
import java.util.Objects;

/**
 * An area of the plan.
 *
 * @param outline a simple polygon, its first point not repeated at the end
 * @param holes likewise
 */
public record MapArea(Kind kind, List<MapPoint> outline, List<List<MapPoint>> holes) {
    /** What an area is for. */
    public enum Kind {
        /** Boats were to explore it. */
        EXPLORED("explored area"),
        /** Of an explored area what no boat came near. */
        UNCOVERED("left uncovered"),
        /** Boats were not to enter it. */
        AVOIDED("avoided area"),
        /** Boats were not to leave it. */
        LIMIT("limit of the water"),
        /** The plan speaks of it otherwise. */
        OTHER("area of the plan");

        private final String words;

        Kind(String words) {
            this.words = words;
        }

        /** As people call it. */
        public String words() {
            return words;
        }
    }

    public MapArea {
        Objects.requireNonNull(kind, "kind");
        outline = List.copyOf(outline);
        holes = holes.stream().map(List::copyOf).toList();
    }
}
