package org.sami.dreamm.inspector;

import java.util.List;
import javax.swing.JComponent;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.issues.IssueWords;
import org.sami.dreamm.profile.ProfileIds;
import org.sami.palette.SemanticColor;
import org.sami.spn.edit.Fix;
import org.sami.spn.finding.Finding;
import org.sami.ui.table.TooltipLines;
import org.sami.ui.value.WrappedText;

/** The findings about the selected elements, with a button next to them for each fix. */
final class FindingRows extends JPanel {
    FindingRows(DreammContext context, List<Finding> findings) {
        super(new MigLayout(
                "novisualpadding, insets 0, gap 8 4, fillx, wrap 2, hidemode 3", "[grow, fill][shrink 50]", "[top]"));
        setName("inspector-findings");
        setOpaque(false);
        List<Finding> shown = findings.stream()
                .filter(finding -> context.profile().shows(ProfileIds.finding(finding.code())))
                .toList();
        if (shown.isEmpty() && context.profile().shows("panel-issues")) {
            add(note("No issue here.", SemanticColor.MUTED), "span 2, wmin 0");
        }
        for (Finding finding : shown) {
            String sign = finding.isError() ? "▲ " : "△ ";
            SemanticColor color = finding.isError() ? SemanticColor.CRITICAL : SemanticColor.WARNING;
            boolean alone = finding.fixes().isEmpty();
            WrappedText row = note(sign + finding.message(), color);
            String advice = IssueWords.advice(finding);
            row.setToolTipText(advice.isEmpty() ? null : TooltipLines.of(advice));
            add(row, alone ? "span 2, wmin 0" : "wmin 0");
            if (!alone) {
                JPanel fixes = new JPanel(new MigLayout("novisualpadding, insets 0, gap 0 4, wrap 1", "[fill]"));
                fixes.setOpaque(false);
                finding.fixes().forEach(fix -> fixes.add(button(context, fix), "hmin 28"));
                add(fixes, "wmax 45%");
            }
        }
    }

    private static WrappedText note(String text, SemanticColor color) {
        WrappedText note = new WrappedText(text);
        note.setColor(color);
        return note;
    }

    private static JComponent button(DreammContext context, Fix fix) {
        return Form.button("Fix: " + fix.label(), "inspector-fix", fix.label(), () -> context.apply(fix.edit()));
    }
}
