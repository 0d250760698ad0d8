package org.sami.crw.cli.legacy;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.sami.spn.finding.Finding;
import org.sami.spn.legacy.LegacyImport;
import org.sami.spn.model.ImportOrigin;
import org.sami.spn.model.Project;

/**
 * Parts the findings about an imported project: those at elements that the import wrote otherwise than they stood in the export,
 * and those of the plans as their authors drew them.
 *
 * @param ofImport in the order of the document
 * @param ofPlans in the order of the document
 */
public record ImportedFindings(ImportOrigin origin, List<Finding> ofImport, List<Finding> ofPlans) {
    private static final Pattern IN_A_PLAN = Pattern.compile("^/plans/(\\d+)(/|$)");

    public ImportedFindings {
        ofImport = List.copyOf(ofImport);
        ofPlans = List.copyOf(ofPlans);
    }

    /** Parts the findings about a project that {@link Project#importedFrom() was imported}. */
    public static ImportedFindings of(Project project, ImportOrigin origin, List<Finding> findings) {
        List<ImportOrigin.Remark> changes =
                origin.remarks().stream().filter(LegacyImport::isChange).toList();
        List<Finding> ofImport = new ArrayList<>();
        List<Finding> ofPlans = new ArrayList<>();
        for (Finding finding : findings) {
            String plan = plan(project, finding);
            boolean changed = changes.stream()
                    .anyMatch(
                            r -> r.plan().equals(plan) && r.elements().stream().anyMatch(finding.elements()::contains));
            (changed ? ofImport : ofPlans).add(finding);
        }
        return new ImportedFindings(origin, ofImport, ofPlans);
    }

    private static String plan(Project project, Finding finding) {
        Matcher matcher = IN_A_PLAN.matcher(finding.pointer());
        if (!matcher.find()) {
            return "";
        }
        int index = Integer.parseInt(matcher.group(1));
        return index < project.plans().size() ? project.plans().get(index).id() : "";
    }

    /** The project's origin and the result of the import, in one line. */
    public String heading() {
        Map<String, Long> codes = origin.remarks().stream()
                .collect(Collectors.groupingBy(ImportOrigin.Remark::code, TreeMap::new, Collectors.counting()));
        String said = codes.entrySet().stream()
                .map(e -> e.getKey() + " " + e.getValue())
                .collect(Collectors.joining(", "));
        return "imported from " + origin.file() + (said.isEmpty() ? "" : "; result of the import: " + said);
    }
}
