package org.sami.spn.value;

import java.util.List;

/** An area: a simple polygon (first point not repeated at the end) with holes; an outline has three points or more. */
public record GeoArea(List<GeoPoint> outline, List<List<GeoPoint>> holes) implements Value {
    public GeoArea {
        outline = List.copyOf(outline);
        holes = holes.stream().map(List::copyOf).toList();
        if (outline.size() < 3) {
            throw new IllegalArgumentException("An area's outline has three points or more, not " + outline.size());
        }
    }
}
