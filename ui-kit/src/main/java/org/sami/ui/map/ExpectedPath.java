package org.sami.ui.map;

import java.util.List;
import java.util.Objects;
import org.sami.palette.IdentityMark;
import org.sami.spn.value.GeoPoint;

/**
 * A path on which a vehicle is expected, though nobody sees it there.
 *
 * @param id stable, unique among paths
 * @param mark its vehicle's
 * @param text the label next to it, in a few words
 */
public record ExpectedPath(String id, IdentityMark mark, List<GeoPoint> points, String text) {
    public ExpectedPath {
        Objects.requireNonNull(id, "id");
        Objects.requireNonNull(mark, "mark");
        points = List.copyOf(points);
        Objects.requireNonNull(text, "text");
    }
}
