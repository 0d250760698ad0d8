package org.sami.petri.pnml;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.sami.petri.pnml.PnmlFinding.Severity;

/** Collects findings; of a kind of which there are very many it keeps the first ones and counts the rest. */
final class FindingList {
    private static final int MOST_OF_A_CODE = 20;

    private final List<PnmlFinding> findings = new ArrayList<>();
    private final Map<String, Integer> counts = new TreeMap<>();
    private final Map<String, Severity> severities = new TreeMap<>();

    void error(String code, int line, String element, String message) {
        add(Severity.ERROR, code, line, element, message);
    }

    void warning(String code, int line, String element, String message) {
        add(Severity.WARNING, code, line, element, message);
    }

    void note(String code, int line, String element, String message) {
        add(Severity.NOTE, code, line, element, message);
    }

    private void add(Severity severity, String code, int line, String element, String message) {
        severities.put(code, severity);
        if (counts.merge(code, 1, Integer::sum) <= MOST_OF_A_CODE) {
            findings.add(new PnmlFinding(severity, code, line, element, message));
        }
    }

    boolean hasErrors() {
        return severities.containsValue(Severity.ERROR);
    }

    List<PnmlFinding> all() {
        List<PnmlFinding> all = new ArrayList<>(findings);
        counts.forEach((code, count) -> {
            if (count > MOST_OF_A_CODE) {
                all.add(new PnmlFinding(
                        severities.getOrDefault(code, Severity.NOTE),
                        code,
                        0,
                        "",
                        "and " + (count - MOST_OF_A_CODE) + " more of this kind"));
            }
        });
        return all;
    }
}
