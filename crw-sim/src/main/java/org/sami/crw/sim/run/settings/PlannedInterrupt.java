package org.sami.crw.sim.run.settings;

import java.util.Objects;
import java.util.Optional;
import java.util.OptionalLong;

/**
 * An interrupt that a run is to press: at a time, or for each boat that turns critical.
 *
 * @param name of the interrupt, as in the plan
 * @param boat the boat that it is for; empty for all, or for those that the operator chooses then
 * @param afterMillis when, in milliseconds since the mission's start; empty = when a boat's battery turns critical
 *     (thesis 7.1.1)
 */
public record PlannedInterrupt(String name, Optional<String> boat, OptionalLong afterMillis) {
    public PlannedInterrupt {
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(boat, "boat");
        Objects.requireNonNull(afterMillis, "afterMillis");
    }

    public boolean isForBattery() {
        return afterMillis.isEmpty();
    }
}
