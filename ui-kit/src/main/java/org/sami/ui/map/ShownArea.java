package org.sami.ui.map;

import java.util.Objects;
import org.sami.spn.value.GeoArea;

/**
 * An area as it is shown on a map.
 *
 * @param id stable, unique among areas
 * @param name what stands in it; empty text where nothing does
 */
public record ShownArea(String id, String name, GeoArea area, Kind kind) {
    /** What an area means. */
    public enum Kind {
        /** Where something is to be done: filled. */
        WORK,
        /** Where none may go: hatched. */
        NO_GO,
        /** What none may leave: a dashed line. */
        FENCE
    }

    public ShownArea {
        Objects.requireNonNull(id, "id");
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(area, "area");
        Objects.requireNonNull(kind, "kind");
    }
}
