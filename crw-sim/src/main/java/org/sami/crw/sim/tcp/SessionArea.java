package org.sami.crw.sim.tcp;

import java.util.List;
import java.util.Objects;
import org.sami.spn.value.GeoPoint;

/**
 * What was found when the boats had answered for the first time; it stays so for the whole run.
 *
 * @param centre of the area in which the locations lie
 * @param boats their names in the order of their addresses
 */
record SessionArea(GeoPoint centre, List<String> boats) {
    SessionArea {
        Objects.requireNonNull(centre, "centre");
        boats = List.copyOf(boats);
    }
}
