package org.sami.lessons.script;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.sami.spn.finding.Finding;
import org.sami.spn.finding.Suggestions;
import org.sami.spn.json.JsonObjectReader;

/** Collects the errors of one script while it is read. */
final class ScriptProblems implements JsonObjectReader.Format {
    private final Set<Finding> findings = new LinkedHashSet<>();

    @Override
    public void add(Finding finding) {
        findings.add(finding);
    }

    @Override
    public boolean nullIsAbsent() {
        return false;
    }

    @Override
    public String emptyCode() {
        return "E-BAD-VALUE";
    }

    @Override
    public Finding unknownMember(String pointer, String member, Set<String> known) {
        return Finding.error(
                "E-UNKNOWN-MEMBER",
                pointer,
                "\"" + member + "\" is not known here; known are " + String.join(", ", known)
                        + Suggestions.meant(known, member));
    }

    boolean none() {
        return findings.isEmpty();
    }

    List<Finding> list() {
        return List.copyOf(findings);
    }
}
