package org.sami.spn.legacy;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.sami.spn.finding.Finding;
import org.sami.spn.finding.Severity;
import org.sami.spn.json.JsonObjectReader;

/** Collects the findings of one import, in order. */
final class Findings implements JsonObjectReader.Format {
    private final List<Finding> findings = new ArrayList<>();

    @Override
    public void add(Finding finding) {
        findings.add(finding);
    }

    /** In the export null means that nothing was set. */
    @Override
    public boolean nullIsAbsent() {
        return true;
    }

    @Override
    public String emptyCode() {
        return LegacyCodes.MISSING;
    }

    /** Warns of a member that this version of the format does not have: what it says does not arrive. */
    @Override
    public Finding unknownMember(String pointer, String member, Set<String> known) {
        return Finding.warning(
                LegacyCodes.UNKNOWN_MEMBER,
                pointer,
                "\"" + member + "\" is not in version " + LegacyReader.VERSION + " of the format; it is not imported");
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
}
