package org.sami.spn.finding;

/** How bad a finding is (thesis 5.1, Mission Issues View). */
public enum Severity {
    /** Prevents the plan from being started. */
    ERROR,
    /** Does not prevent a run, but may lead to behaviour that nobody wants. */
    WARNING,
    /** Worth knowing. */
    NOTE
}
