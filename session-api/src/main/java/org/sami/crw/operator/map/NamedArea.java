package org.sami.crw.operator.map;

import java.util.Objects;
import org.sami.spn.value.GeoArea;

/**
 * An area on the map.
 *
 * @param layer {@link ShownLayer#AREAS}, {@link ShownLayer#NO_GO}, {@link ShownLayer#FENCE} or {@link ShownLayer#RELEVANT_AREA}
 * @param mission that speaks of it; {@code Ids.NONE} for one of the project's or the session's
 * @param name of the variable, event or purpose
 */
public record NamedArea(ShownLayer layer, long mission, String name, GeoArea area) {
    public NamedArea {
        Objects.requireNonNull(layer, "layer");
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(area, "area");
    }
}
