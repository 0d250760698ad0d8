package org.sami.crw.cli.legacy;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.sami.spn.finding.Finding;

/** Findings in words for people, those of one code together: how often, in which plans, and one of them as an example. */
final class FindingGroups {
    private static final int MOST_PLANS = 6;

    private FindingGroups() {}

    /**
     * Prints one paragraph a code, errors first, then warnings, then notes.
     *
     * @param planOf the name of the plan that a finding is about; empty text where it is about none
     */
    static String text(List<Finding> findings, Function<Finding, String> planOf) {
        Map<String, List<Finding>> byCode = findings.stream()
                .sorted(Comparator.comparing(Finding::severity))
                .collect(Collectors.groupingBy(Finding::code, LinkedHashMap::new, Collectors.toList()));
        StringBuilder text = new StringBuilder();
        byCode.forEach((code, same) -> text.append(paragraph(code, same, planOf)));
        return text.toString();
    }

    private static String paragraph(String code, List<Finding> same, Function<Finding, String> planOf) {
        Finding first = same.get(0);
        String where = plans(same, planOf);
        return String.format(
                Locale.ROOT,
                "%s %s: %d%s%n  %s%s%n",
                first.severity().name().toLowerCase(Locale.ROOT),
                code,
                same.size(),
                where.isEmpty() ? "" : " in " + where,
                same.size() > 1 ? "such as " : "",
                (first.pointer().isEmpty() ? "" : first.pointer() + ": ") + first.message());
    }

    private static String plans(List<Finding> same, Function<Finding, String> planOf) {
        Map<String, Long> counts = same.stream()
                .map(planOf)
                .filter(plan -> !plan.isEmpty())
                .collect(Collectors.groupingBy(plan -> plan, LinkedHashMap::new, Collectors.counting()));
        List<String> words = new ArrayList<>();
        counts.entrySet().stream()
                .sorted(Map.Entry.<String, Long>comparingByValue().reversed())
                .limit(MOST_PLANS)
                .forEach(e -> words.add(counts.size() == 1 ? e.getKey() : e.getKey() + " (" + e.getValue() + ")"));
        if (counts.size() > MOST_PLANS) {
            words.add(counts.size() - MOST_PLANS + " more plans");
        }
        return String.join(", ", words);
    }
}
