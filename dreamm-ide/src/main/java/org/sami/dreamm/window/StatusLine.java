package org.sami.dreamm.window;

import java.util.Optional;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.sami.dreamm.context.DreammContext;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.Icons;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;
import org.sami.ui.look.SemanticColor;
import org.sami.ui.window.Notices.Notice;

/** The line at the foot of the window: what was done last or why it was refused, and where the project is saved. */
final class StatusLine extends JPanel {
    private final JLabel notice = new JLabel();
    private final JLabel file = new JLabel();
    private Optional<Notice> last = Optional.empty();

    /**
     * The line of a window.
     *
     * @param corner stands at its right end
     */
    StatusLine(DreammContext context, JComponent corner) {
        super(new MigLayout("insets 4 12 4 12, gap 16", "[grow, fill][][]", "[]"));
        setName("status-line");
        notice.setName("notice");
        file.setName("project-file");
        add(notice, "wmin 0, h 20!");
        add(file, "wmax 45%");
        add(corner);
        context.notices().addListener(this::show);
        style();
    }

    private void show(Notice told) {
        last = Optional.of(told);
        notice.setText(told.text());
        notice.setToolTipText(told.text());
        notice.getAccessibleContext().setAccessibleName((told.refused() ? "Refused: " : "") + told.text());
        notice.setIcon(Icons.of(
                told.refused() ? "alarm" : "check",
                Look.px(16),
                told.refused() ? SemanticColor.WARNING : SemanticColor.OK));
        LookColors.foreground(notice, told.refused() ? SemanticColor.WARNING : SemanticColor.MUTED);
    }

    /** Says where the project is saved. */
    void showFile(String text, String tip) {
        file.setText(text);
        file.setToolTipText(tip);
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (notice != null) {
            style();
        }
    }

    private void style() {
        LookColors.background(this, SemanticColor.SURFACE_RAISED);
        LookColors.border(this, () -> BorderFactory.createMatteBorder(1, 0, 0, 0, SemanticColor.BORDER.get()));
        notice.setFont(Fonts.text());
        file.setFont(Fonts.text());
        LookColors.foreground(file, SemanticColor.MUTED);
        last.ifPresent(this::show);
    }
}
