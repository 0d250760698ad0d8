package org.sami.crw.cli.legacy;

import java.util.List;
import java.util.Objects;
import org.sami.crw.operator.mission.Wait;
import org.sami.crw.report.RunOutcome;
import org.sami.spn.finding.Finding;

/**
 * How the trial run of one plan went.
 *
 * @param reason why it went wrong, in one sentence; empty where it did not
 * @param decisions how many questions the operator was asked
 * @param messages how many the operator got
 * @param waitsFor where it stood at the end of its time and what for; empty unless it still ran
 * @param findings what came to light of the plan, by the checks and by the run
 */
public record PlanTrial(
        String plan,
        String name,
        RunOutcome outcome,
        String reason,
        long simulatedMillis,
        int firings,
        int decisions,
        int messages,
        List<Wait> waitsFor,
        List<Finding> findings) {
    public PlanTrial {
        Objects.requireNonNull(plan, "plan");
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(outcome, "outcome");
        Objects.requireNonNull(reason, "reason");
        waitsFor = List.copyOf(waitsFor);
        findings = List.copyOf(findings);
    }

    /** Whether engine and domain did what the plan says, however well that was drawn. */
    public boolean isSound() {
        return outcome != RunOutcome.FAILED && findings.stream().noneMatch(f -> TrialCodes.FAULTS.contains(f.code()));
    }
}
