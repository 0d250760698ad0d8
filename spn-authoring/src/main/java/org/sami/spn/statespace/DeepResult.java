package org.sami.spn.statespace;

import java.util.List;
import java.util.Objects;

/**
 * What came of a deep check.
 *
 * @param states how many states were looked at
 * @param complete whether those were all that the tried steps lead to; else the bound was met or somebody stopped it
 * @param summary one sentence: what was looked at, and what that says
 */
public record DeepResult(List<DeepFinding> findings, int states, boolean complete, String summary) {
    public DeepResult {
        findings = List.copyOf(findings);
        Objects.requireNonNull(summary, "summary");
    }
}
