package org.sami.crw.operator.map;

import java.util.Objects;
import org.sami.spn.value.GeoPoint;

/**
 * A place on the map.
 *
 * @param mission that speaks of it; {@code Ids.NONE} for one of the project's
 * @param name of the variable, or of the event whose markup Relevant Area names it
 */
public record ShownPlace(long mission, String name, GeoPoint point) {
    public ShownPlace {
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(point, "point");
    }
}
