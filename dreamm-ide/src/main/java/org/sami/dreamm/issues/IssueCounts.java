package org.sami.dreamm.issues;

import java.util.List;
import org.sami.spn.finding.Severity;

/** How many issues there are of each severity. */
public record IssueCounts(int errors, int warnings, int notes) {
    static IssueCounts of(List<Issue> issues) {
        return new IssueCounts(
                count(issues, Severity.ERROR), count(issues, Severity.WARNING), count(issues, Severity.NOTE));
    }

    private static int count(List<Issue> issues, Severity severity) {
        return (int) issues.stream()
                .filter(issue -> issue.finding().severity() == severity)
                .count();
    }

    /** In words, such as "2 errors, 1 warning"; what there is none of is left out. */
    public String words() {
        String words = List.of(words(errors, "error"), words(warnings, "warning"), words(notes, "note")).stream()
                .filter(text -> !text.isEmpty())
                .reduce((a, b) -> a + ", " + b)
                .orElse("");
        return words.isEmpty() ? "no issues" : words;
    }

    private static String words(int count, String what) {
        return count == 0 ? "" : count + " " + what + (count == 1 ? "" : "s");
    }
}
