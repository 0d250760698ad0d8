package org.sami.crw.report;

import com.fasterxml.jackson.annotation.JsonProperty;
import java.util.Objects;

/**
 * One action of a mission's phase chart (thesis 5.2.3), and how it stood at the end.
 *
 * @param mission its id
 * @param plan id of the mission's plan
 * @param label what the chart says
 * @param status {@code ahead}, {@code active} or {@code done}
 * @param executions how often it was begun
 */
public record PhaseResult(
        long mission,
        String plan,
        String phase,
        String actor,
        @JsonProperty("action") String label,
        String status,
        int executions) {
    public PhaseResult {
        Objects.requireNonNull(plan, "plan");
        Objects.requireNonNull(phase, "phase");
        Objects.requireNonNull(actor, "actor");
        Objects.requireNonNull(label, "label");
        Objects.requireNonNull(status, "status");
    }
}
