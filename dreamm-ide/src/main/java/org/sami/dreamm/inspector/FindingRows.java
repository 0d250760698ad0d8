package org.sami.dreamm.inspector;

import java.util.List;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.profile.ProfileIds;
import org.sami.spn.finding.Finding;
import org.sami.ui.look.SemanticColor;

/** The findings about what is selected, with a button for each fix that they offer. */
final class FindingRows extends Form {
    FindingRows(DreammContext context, List<Finding> findings) {
        setName("inspector-findings");
        for (Finding finding : findings) {
            if (!context.profile().shows(ProfileIds.finding(finding.code()))) {
                continue;
            }
            note(
                    (finding.isError() ? "▲ " : "△ ") + finding.message(),
                    finding.isError() ? SemanticColor.CRITICAL : SemanticColor.WARNING);
            finding.fixes()
                    .forEach(fix -> wide(button(
                            "Fix: " + fix.label(), "inspector-fix", fix.label(), () -> context.apply(fix.edit()))));
        }
    }
}
