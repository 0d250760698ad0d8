package org.sami.dreamm.inspector;

import java.util.List;
import java.util.Set;
import org.sami.dreamm.context.DreammContext;
import org.sami.spn.finding.Finding;
import org.sami.ui.look.SemanticColor;

/** The findings about what is selected, with a button for each fix that they offer. */
final class FindingRows extends Form {
    FindingRows(DreammContext context, List<Finding> findings, String plan, Set<String> ids) {
        setName("inspector-findings");
        findings.stream()
                .filter(f -> f.plan().equals(plan))
                .filter(f -> f.elements().stream().anyMatch(ids::contains))
                .forEach(f -> {
                    note(
                            (f.isError() ? "▲ " : "△ ") + f.message(),
                            f.isError() ? SemanticColor.CRITICAL : SemanticColor.WARNING);
                    f.fixes()
                            .forEach(fix -> wide(button(
                                    "Fix: " + fix.label(),
                                    "inspector-fix",
                                    fix.label(),
                                    () -> context.apply(fix.edit()))));
                });
    }
}
