package org.sami.lessons.check;

import java.util.ArrayList;
import java.util.List;
import org.sami.spn.finding.Finding;

/** Collects what is wrong with one lesson, each with its place in {@code lesson.json}. */
final class LessonProblems {
    private final List<Finding> findings = new ArrayList<>();

    /** Something is wrong at a place. */
    void add(String pointer, String message) {
        findings.add(Finding.error("E-LESSON", pointer, message));
    }

    List<Finding> findings() {
        return findings;
    }
}
