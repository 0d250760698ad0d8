package org.sami.spn.json;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.sami.spn.finding.Finding;
import org.sami.spn.finding.Suggestions;

/** Collects the errors of one document while it is read; the same error is kept once. */
final class Problems implements JsonObjectReader.Format {
    private final Set<Finding> findings = new LinkedHashSet<>();

    void add(String code, String pointer, String message, String... elements) {
        findings.add(Finding.error(code, pointer, message, elements));
    }

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
        return Codes.BAD_VALUE;
    }

    @Override
    public Finding unknownMember(String pointer, String member, Set<String> known) {
        return Finding.error(
                Codes.UNKNOWN_MEMBER,
                pointer,
                "\"" + member + "\" is not known here; known are " + String.join(", ", known)
                        + Suggestions.meant(known, member));
    }

    /** Adds findings of another document whose place in this one, or whose name, is given. */
    void addAll(List<Finding> others, String prefix) {
        for (Finding f : others) {
            findings.add(f.within(prefix));
        }
    }

    boolean none() {
        return findings.stream().noneMatch(Finding::isError);
    }

    int count() {
        return findings.size();
    }

    List<Finding> findings() {
        return List.copyOf(findings);
    }

    /** A pointer one step deeper, escaped after RFC 6901. */
    static String at(String pointer, String member) {
        return JsonObjectReader.at(pointer, member);
    }

    static String at(String pointer, int index) {
        return pointer + "/" + index;
    }
}
