package org.sami.spn.value;

import java.util.List;

/** A path: points in the order in which they are visited; may be empty. */
public record GeoPath(List<GeoPoint> points) implements Value {
    public GeoPath {
        points = List.copyOf(points);
    }
}
