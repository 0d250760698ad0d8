package org.sami.dreamm.issues;

import java.util.EnumSet;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.finding.Finding;
import org.sami.spn.finding.Severity;

/**
 * Which issues are shown.
 *
 * @param plan only those of this plan, by its id; empty = of all
 * @param text only those whose code, message or plan contains it, whatever its case
 */
public record IssueFilter(Set<Severity> severities, Optional<String> plan, String text) {
    /** Everything is shown. */
    public static final IssueFilter ALL = new IssueFilter(EnumSet.allOf(Severity.class), Optional.empty(), "");

    public IssueFilter {
        severities = Set.copyOf(severities);
        Objects.requireNonNull(plan, "plan");
        Objects.requireNonNull(text, "text");
    }

    /** The same with a severity shown or hidden. */
    public IssueFilter with(Severity severity, boolean shown) {
        Set<Severity> next = EnumSet.noneOf(Severity.class);
        next.addAll(severities);
        if (shown) {
            next.add(severity);
        } else {
            next.remove(severity);
        }
        return new IssueFilter(next, plan, text);
    }

    /** The same for a plan, or for all. */
    public IssueFilter of(Optional<String> onlyPlan) {
        return new IssueFilter(severities, onlyPlan, text);
    }

    /** The same with another text. */
    public IssueFilter containing(String words) {
        return new IssueFilter(severities, plan, words);
    }

    boolean shows(Issue issue) {
        Finding finding = issue.finding();
        String all = finding.code() + "\n" + finding.message() + "\n" + finding.plan();
        return severities.contains(finding.severity())
                && plan.map(finding.plan()::equals).orElse(true)
                && all.toLowerCase(Locale.ROOT).contains(text.strip().toLowerCase(Locale.ROOT));
    }
}
