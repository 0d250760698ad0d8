package org.sami.crw.sim.run.record;

import java.util.List;
import java.util.Objects;
import java.util.OptionalLong;
import java.util.function.Function;
import org.sami.crw.report.LinkResult;
import org.sami.crw.report.RunOutcome;

/**
 * The state of a run when its report was made.
 *
 * @param reason one sentence where the outcome needs one, else empty
 * @param wallSeconds what this process took for it
 * @param resumedFrom index of the last input that was taken from a journal; empty for a run from its start
 * @param boats as they are at the end
 * @param links gives each boat's link
 */
public record ReportEnd(
        RunOutcome outcome,
        String reason,
        long atMillis,
        double wallSeconds,
        OptionalLong resumedFrom,
        List<BoatState> boats,
        Function<String, LinkResult> links) {
    public ReportEnd {
        Objects.requireNonNull(outcome, "outcome");
        Objects.requireNonNull(reason, "reason");
        Objects.requireNonNull(resumedFrom, "resumedFrom");
        boats = List.copyOf(boats);
        Objects.requireNonNull(links, "links");
    }
}
