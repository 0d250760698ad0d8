package org.sami.dreamm.issues;

import java.awt.Cursor;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.List;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.sami.palette.SemanticColor;
import org.sami.spn.finding.Severity;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.LookColors;

/** How many errors and warnings there are, for the window's corner; a click opens the issues. */
public final class IssueCounters extends JPanel {
    private final transient IssueList issues;
    private final JLabel errors = new JLabel();
    private final JLabel warnings = new JLabel();

    /**
     * Counters of issues.
     *
     * @param open shows the issues
     */
    public IssueCounters(IssueList issues, Runnable open) {
        super(new MigLayout("insets 0, gap 12", "[][]", "[]"));
        this.issues = issues;
        setName("issue-counters");
        setOpaque(false);
        setCursor(Cursor.getPredefinedCursor(Cursor.HAND_CURSOR));
        errors.setName("count-errors");
        warnings.setName("count-warnings");
        for (JLabel label : List.of(errors, warnings)) {
            add(label);
            label.addMouseListener(new MouseAdapter() {
                @Override
                public void mousePressed(MouseEvent e) {
                    open.run();
                }
            });
        }
        issues.addListener(this::refresh);
        refresh();
    }

    private void refresh() {
        IssueCounts counts = issues.counts();
        show(errors, Severity.ERROR, counts.errors(), SemanticColor.CRITICAL);
        show(warnings, Severity.WARNING, counts.warnings(), SemanticColor.WARNING);
        String tip =
                counts.words() + (issues.isChecking() ? ", checking…" : "") + "; click for the list, F8 for the next";
        errors.setToolTipText(tip);
        warnings.setToolTipText(tip);
        getAccessibleContext().setAccessibleName(counts.words());
    }

    private static void show(JLabel label, Severity severity, int count, SemanticColor color) {
        label.setText(String.valueOf(count));
        label.setFont(Fonts.strong());
        label.setIcon(IssuesPanel.icon(severity));
        LookColors.foreground(label, count == 0 ? SemanticColor.MUTED : color);
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (warnings != null) {
            refresh();
        }
    }
}
