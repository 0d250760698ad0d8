package org.sami.crw.gui.mission;

import java.util.Optional;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.sami.crw.operator.mission.StuckMission;
import org.sami.ui.command.CommandButton;
import org.sami.ui.command.CommandRegistry;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;
import org.sami.ui.look.SemanticColor;
import org.sami.ui.replay.SessionClock;
import org.sami.ui.value.WrappedText;

/** Says below a mission's head that it cannot go on, since when, why and what would help, and has what failed sent again. Not seen while it goes on. */
final class StuckBar extends JPanel {
    private static final String INSETS = "insets 6 12 6 12";
    private static final String LOW_INSETS = "insets 1 12 1 4";

    private final WrappedText text = new WrappedText("");
    private final JLabel brief = new JLabel();
    private final CommandButton again;
    private final transient MigLayout layout = new MigLayout("", "[grow,fill][]");
    private boolean low;

    StuckBar(CommandRegistry commands) {
        setLayout(layout);
        setName("mission-stuck");
        text.setName("mission-stuck-text");
        again = new CommandButton(commands.get("mission-send-again"));
        brief.setName("mission-stuck-brief");
        add(text, "wmin 60");
        add(brief, "wmin 0");
        add(again);
        arrange();
        LookColors.background(this, SemanticColor.SURFACE_RAISED);
        LookColors.border(
                this, () -> BorderFactory.createMatteBorder(0, Look.px(6), 0, 0, SemanticColor.WARNING_FILL.get()));
        setVisible(false);
    }

    private void arrange() {
        layout.setLayoutConstraints("novisualpadding, " + (low ? LOW_INSETS : INSETS) + ", gap 8 4, fillx, hidemode 3");
        text.setVisible(!low);
        brief.setVisible(low);
        revalidate();
    }

    /** Says it in one line, as the panel is low; the whole of it is in the tooltip. */
    void setLow(boolean low) {
        if (low != this.low) {
            this.low = low;
            arrange();
        }
    }

    /** Shows it, or nothing. */
    void show(Optional<StuckMission> stuck) {
        setVisible(stuck.isPresent());
        stuck.ifPresent(one -> {
            String what = "Stuck since " + SessionClock.text(one.sinceMillis()) + ": " + one.what() + ".";
            text.setText(what + "\n" + one.help() + ".");
            brief.setText("Stuck: " + one.what());
            brief.setToolTipText(what + " " + one.help() + ".");
            again.setVisible(one.canBeSentAgain());
        });
    }
}
