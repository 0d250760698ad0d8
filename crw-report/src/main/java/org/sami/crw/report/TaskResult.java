package org.sami.crw.report;

import java.util.Objects;
import java.util.Optional;
import java.util.OptionalLong;

/**
 * What became of one task.
 *
 * @param mission the mission that owns it
 * @param boat who did it, or has it now; empty text where nobody has
 * @param allocations how often a boat got it that did not have it
 * @param startedAtMillis simulated time at which a boat first began with it
 * @param completedAtMillis simulated time at which its plan last completed it; empty where it is not
 */
public record TaskResult(
        long mission,
        String task,
        Optional<Place> location,
        String boat,
        int allocations,
        OptionalLong startedAtMillis,
        OptionalLong completedAtMillis) {
    /** Where it is to be done, in degrees on WGS 84. */
    public record Place(double latDeg, double lonDeg) {}

    public TaskResult {
        Objects.requireNonNull(task, "task");
        Objects.requireNonNull(location, "location");
        Objects.requireNonNull(boat, "boat");
        Objects.requireNonNull(startedAtMillis, "startedAtMillis");
        Objects.requireNonNull(completedAtMillis, "completedAtMillis");
    }

    /** Whether it is complete. */
    public boolean isComplete() {
        return completedAtMillis.isPresent();
    }
}
