package org.sami.crw.sim.layer;

import java.util.Objects;
import java.util.Optional;

/**
 * What differs by place on the simulated water. Immutable.
 *
 * @param depths that boats measure with their sonar; empty where boats have none
 * @param currents that carry boats, added to the current of the conditions; empty where that one is all
 */
public record WaterLayers(Optional<DepthGrid> depths, Optional<CurrentField> currents) {
    /** The same water everywhere, of unknown depth. */
    public static final WaterLayers NONE = new WaterLayers(Optional.empty(), Optional.empty());

    public WaterLayers {
        Objects.requireNonNull(depths, "depths");
        Objects.requireNonNull(currents, "currents");
    }

    /** Whether the water is the same everywhere, and its depth unknown. */
    public boolean isEmpty() {
        return depths.isEmpty() && currents.isEmpty();
    }
}
