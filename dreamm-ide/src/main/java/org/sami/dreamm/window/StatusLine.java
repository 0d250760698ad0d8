package org.sami.dreamm.window;

import java.util.Optional;
import java.util.function.LongSupplier;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.Timer;
import net.miginfocom.swing.MigLayout;
import org.sami.dreamm.context.DreammContext;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.Icons;
import org.sami.ui.look.LookColors;
import org.sami.ui.look.SemanticColor;
import org.sami.ui.window.Notices.Notice;
import org.sami.ui.window.ShownNotice;

/**
 * The line at the foot of the window: what was done last or why it was refused, for as long as it is news, and where the project is saved. On
 * the event thread.
 */
final class StatusLine extends JPanel {
    private final JLabel notice = new JLabel();
    private final JLabel file = new JLabel();
    private final transient ShownNotice shown;
    private final transient Timer leaves = new Timer(0, e -> refresh());

    /**
     * The line of a window.
     *
     * @param corner stands at its right end
     * @param nanos a clock that only goes on, in ns
     */
    StatusLine(DreammContext context, JComponent corner, LongSupplier nanos) {
        super(new MigLayout("insets 4 12 4 12, gap 16", "[grow, fill][][]", "[]"));
        shown = new ShownNotice(nanos);
        leaves.setRepeats(false);
        setName("status-line");
        notice.setName("notice");
        file.setName("project-file");
        add(notice, "wmin 0, h 20!");
        add(file, "wmax 45%");
        add(corner);
        context.notices().addListener(told -> {
            shown.tell(told);
            refresh();
        });
        style();
    }

    /** Shows what is news now; asked again when it is none any longer. */
    void refresh() {
        Optional<Notice> now = shown.now();
        String text = now.map(Notice::text).orElse("");
        boolean refused = now.filter(Notice::refused).isPresent();
        notice.setText(text);
        notice.setToolTipText(now.isPresent() ? text : null);
        notice.getAccessibleContext().setAccessibleName((refused ? "Refused: " : "") + text);
        notice.setIcon(
                now.isEmpty()
                        ? null
                        : Icons.of(
                                refused ? "alarm" : "check", 16, refused ? SemanticColor.WARNING : SemanticColor.OK));
        LookColors.foreground(notice, refused ? SemanticColor.WARNING : SemanticColor.MUTED);
        if (now.isPresent()) {
            leaves.setInitialDelay(Math.toIntExact(shown.leftMillis()));
            leaves.restart();
        }
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
        refresh();
    }
}
