package org.sami.spn.legacy;

import java.util.ArrayList;
import java.util.List;
import org.sami.spn.finding.Finding;
import org.sami.spn.finding.Severity;

/** Collects the findings of one import, in order. */
final class Findings {
    private final List<Finding> findings = new ArrayList<>();

    void add(Finding finding) {
        findings.add(finding);
    }

    void error(String code, String pointer, String message, String... elements) {
        findings.add(Finding.error(code, pointer, message, elements));
    }

    void warning(String code, String pointer, String message, String... elements) {
        findings.add(Finding.warning(code, pointer, message, elements));
    }

    void note(String code, String pointer, String message, String... elements) {
        findings.add(new Finding(Severity.NOTE, code, pointer, message, List.of(elements)));
    }

    boolean hasErrors() {
        return findings.stream().anyMatch(Finding::isError);
    }

    List<Finding> list() {
        return List.copyOf(findings);
    }

    /** A pointer one step deeper, escaped after RFC 6901. */
    static String at(String pointer, String member) {
        return pointer + "/" + member.replace("~", "~0").replace("/", "~1");
    }
}
