package org.sami.dreamm.issues;

import org.sami.spn.advice.FindingAdvice;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;

/** What an issue says to the author: what is wrong, why it matters, how it is mended. */
public final class IssueWords {
    private IssueWords() {}

    /** All of it, a line each. */
    static String of(Issue issue) {
        String byHand = issue.fixes().isEmpty() && issue.witness().isEmpty()
                ? "  To be mended by hand: what it is about is marked on the net."
                : "";
        return issue.finding().message() + "." + byHand
                + FindingAdvice.of(issue.finding())
                        .map(advice -> "\n" + lines(advice))
                        .orElse("");
    }

    /** Why a finding matters and how it is mended, a line each; empty text where nothing is known of its code. */
    public static String advice(Finding finding) {
        return FindingAdvice.of(finding).map(IssueWords::lines).orElse("");
    }

    private static String lines(Advice advice) {
        return "Why it matters: " + advice.why() + "\nHow to mend it: " + advice.mend();
    }
}
