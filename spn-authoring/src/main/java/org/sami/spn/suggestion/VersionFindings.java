package org.sami.spn.suggestion;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.sami.spn.finding.Finding;
import org.sami.spn.finding.Severity;

/**
 * The findings about one version of a plan.
 *
 * @param findings errors and warnings by what they are about, whatever the team
 * @param complete whether the searches looked at every state
 */
record VersionFindings(Map<String, Finding> findings, boolean complete) {
    /** A search that did not look at every state calls what it has not reached a note; it counts as if it were never reached. */
    private static final Map<String, String> SAME = Map.of("N-NOT-REACHED", "W-NEVER-REACHED");

    static VersionFindings of(List<Finding> found, boolean complete) {
        Map<String, Finding> findings = new LinkedHashMap<>();
        found.stream()
                .filter(finding -> finding.severity() != Severity.NOTE || SAME.containsKey(finding.code()))
                .forEach(finding -> findings.putIfAbsent(key(finding), finding));
        return new VersionFindings(findings, complete);
    }

    private static String key(Finding finding) {
        String elements = finding.elements().stream().sorted().distinct().collect(Collectors.joining(" "));
        return code(finding) + " " + elements + " " + finding.plan();
    }

    /** The finding's code; one for both ways of saying that something is not reached. */
    static String code(Finding finding) {
        return SAME.getOrDefault(finding.code(), finding.code());
    }

    VersionFindings and(VersionFindings other) {
        Map<String, Finding> both = new LinkedHashMap<>(findings);
        other.findings.forEach(both::putIfAbsent);
        return new VersionFindings(both, complete && other.complete);
    }

    long errors() {
        return findings.values().stream().filter(Finding::isError).count();
    }

    int size() {
        return findings.size();
    }

    /** The findings that another version does not have. */
    List<Finding> without(VersionFindings other) {
        Set<String> there = other.findings.keySet();
        return findings.entrySet().stream()
                .filter(found -> !there.contains(found.getKey()))
                .map(Map.Entry::getValue)
                .toList();
    }
}
