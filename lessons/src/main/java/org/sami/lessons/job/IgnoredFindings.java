package org.sami.lessons.job;

import java.util.List;
import java.util.Locale;
import org.sami.lessons.course.LessonMode;
import org.sami.spn.finding.Finding;

/** Which findings do not count in a job: those that it names, and those that its lesson's mode hides. */
record IgnoredFindings(Job job, LessonMode mode) {
    private static final String PREFIX = "finding-";

    boolean isIgnored(String code) {
        String id = PREFIX + code.toLowerCase(Locale.ROOT);
        return job.ignored().contains(code) || (isAmong(mode.hide(), id) && !isAmong(mode.keep(), id));
    }

    private static boolean isAmong(List<String> patterns, String id) {
        return patterns.stream()
                .anyMatch(pattern -> pattern.endsWith("*")
                        ? id.startsWith(pattern.substring(0, pattern.length() - 1))
                        : id.equals(pattern));
    }

    /** The errors that count, in their order. */
    List<Finding> counting(List<Finding> findings) {
        return findings.stream()
                .filter(finding -> finding.isError() && !isIgnored(finding.code()))
                .toList();
    }
}
