package org.sami.spn.analysis;

import java.util.Comparator;
import java.util.List;
import org.sami.spn.finding.Finding;

/** The order of findings in a project's document; findings at one place keep the order in which they were made. */
final class DocumentOrder {
    static final Comparator<Finding> BY_POINTER = (a, b) -> compare(a.pointer(), b.pointer());

    private static final List<String> MEMBERS = List.of(
            "globals",
            "missionTree",
            "plans",
            "variables",
            "reads",
            "tasks",
            "places",
            "transitions",
            "inEdges",
            "outEdges");

    private DocumentOrder() {}

    private static int compare(String a, String b) {
        String[] left = a.split("/");
        String[] right = b.split("/");
        for (int i = 0; i < Math.min(left.length, right.length); i++) {
            int order = compareStep(left[i], right[i]);
            if (order != 0) {
                return order;
            }
        }
        return Integer.compare(left.length, right.length);
    }

    private static int compareStep(String a, String b) {
        if (isIndex(a) && isIndex(b)) {
            return a.length() == b.length() ? a.compareTo(b) : Integer.compare(a.length(), b.length());
        }
        int rank = Integer.compare(MEMBERS.indexOf(a), MEMBERS.indexOf(b));
        return rank != 0 ? rank : a.compareTo(b);
    }

    private static boolean isIndex(String step) {
        return !step.isEmpty() && step.chars().allMatch(c -> c >= '0' && c <= '9');
    }
}
