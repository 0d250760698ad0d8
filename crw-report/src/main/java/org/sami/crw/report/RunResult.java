package org.sami.crw.report;

import java.util.Objects;
import java.util.OptionalLong;

/**
 * How it came out.
 *
 * @param reason one sentence where the outcome needs one, else empty text
 * @param simulatedMillis simulated time when the run stopped, in milliseconds since its start
 * @param wallSeconds what this process took for it
 * @param clicks what the operator had to do, counted as docs/command-line.md says
 * @param firings how many transitions fired
 * @param resumedFrom index of the last input that was taken from a journal; empty for a run from its start
 * @param runHash SHA-256 in hexadecimal digits over all firings, activations and final positions
 */
public record RunResult(
        RunOutcome outcome,
        String reason,
        long simulatedMillis,
        double wallSeconds,
        int clicks,
        long firings,
        OptionalLong resumedFrom,
        String runHash) {
    public RunResult {
        Objects.requireNonNull(outcome, "outcome");
        Objects.requireNonNull(reason, "reason");
        Objects.requireNonNull(resumedFrom, "resumedFrom");
        Objects.requireNonNull(runHash, "runHash");
    }
}
