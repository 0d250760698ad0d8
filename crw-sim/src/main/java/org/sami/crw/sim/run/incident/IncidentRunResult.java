package org.sami.crw.sim.run.incident;

import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.OptionalDouble;
import org.sami.crw.operator.ClickKind;
import org.sami.crw.report.RunOutcome;

/**
 * What came of a run with incidents.
 *
 * @param outcome ended where the script came to its end and all its missions have ended
 * @param reason why it did not, in a sentence; else empty text
 * @param millis from the first start to the last end of a mission
 * @param clicks of all missions, by kind
 * @param recharges batteries that were changed
 * @param incidents as they were placed
 * @param notPlaced number of incidents that came after the missions' end
 * @param unvisited number of locations that no boat reported
 * @param resolution mean of the measured spans in seconds; empty where none was measured
 * @param measurements readings of all boats of which none is within 1 m of an earlier one
 * @param hash equal for equal runs
 */
public record IncidentRunResult(
        RunOutcome outcome,
        String reason,
        long millis,
        Map<ClickKind, Long> clicks,
        int recharges,
        List<IncidentKind.PlannedIncident> incidents,
        int notPlaced,
        int unvisited,
        OptionalDouble resolution,
        int measurements,
        String hash) {
    public IncidentRunResult {
        Objects.requireNonNull(outcome, "outcome");
        Objects.requireNonNull(reason, "reason");
        clicks = Map.copyOf(clicks);
        incidents = List.copyOf(incidents);
        Objects.requireNonNull(resolution, "resolution");
        Objects.requireNonNull(hash, "hash");
    }

    /** All clicks. */
    public long allClicks() {
        return clicks.values().stream().mapToLong(Long::longValue).sum();
    }
}
