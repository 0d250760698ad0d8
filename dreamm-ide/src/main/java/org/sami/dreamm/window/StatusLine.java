package org.sami.dreamm.window;

import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.sami.dreamm.context.DreammContext;
import org.sami.palette.SemanticColor;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.LookColors;
import org.sami.ui.window.NoticeLabel;

/**
 * The line at the foot of the window: what was done last or why it was refused, for as long as it is news, and where the project is saved. On
 * the event thread.
 */
final class StatusLine extends JPanel {
    private final JLabel file = new JLabel();

    /**
     * The line of a window.
     *
     * @param corner stands at its right end
     */
    StatusLine(DreammContext context, JComponent corner) {
        super(new MigLayout("insets 4 12 4 12, gap 16", "[grow, fill][][]", "[]"));
        setName("status-line");
        file.setName("project-file");
        add(new NoticeLabel(context.notices(), System::nanoTime), "wmin 0, h 20!");
        add(file, "wmax 45%");
        add(corner);
        style();
    }

    /** Says where the project is saved. */
    void showFile(String text, String tip) {
        file.setText(text);
        file.setToolTipText(tip);
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (file != null) {
            style();
        }
    }

    private void style() {
        LookColors.background(this, SemanticColor.SURFACE_RAISED);
        LookColors.border(this, () -> BorderFactory.createMatteBorder(1, 0, 0, 0, SemanticColor.BORDER.get()));
        file.setFont(Fonts.text());
        LookColors.foreground(file, SemanticColor.MUTED);
    }
}
