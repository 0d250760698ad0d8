package org.sami.ui.map.base;

import java.util.Arrays;
import java.util.Optional;

/** The geometries of RFC 7946 that have coordinates. */
enum GeometryType {
    POINT("Point", 1),
    MULTI_POINT("MultiPoint", 2),
    LINE("LineString", 2),
    MULTI_LINE("MultiLineString", 3),
    POLYGON("Polygon", 3),
    MULTI_POLYGON("MultiPolygon", 4);

    private final String word;
    private final int depth;

    GeometryType(String word, int depth) {
        this.word = word;
        this.depth = depth;
    }

    static Optional<GeometryType> of(String word) {
        return Arrays.stream(values()).filter(type -> type.word.equals(word)).findFirst();
    }

    /** Lines of a depth, before the document has named their type. */
    static Optional<GeometryType> linesOf(int depth) {
        return depth < 2 ? Optional.empty() : Optional.of(depth == 2 ? LINE : MULTI_LINE);
    }

    String word() {
        return word;
    }

    /** In how many lists a position lies, its own included. */
    int depth() {
        return depth;
    }

    boolean isPoints() {
        return this == POINT || this == MULTI_POINT;
    }

    boolean isPolygons() {
        return this == POLYGON || this == MULTI_POLYGON;
    }
}
