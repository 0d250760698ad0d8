package org.sami.crw.gui.mission;

import javax.swing.BorderFactory;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.sami.crw.operator.mission.StuckMission;
import org.sami.palette.SemanticColor;
import org.sami.ui.command.CommandButton;
import org.sami.ui.command.CommandRegistry;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;
import org.sami.ui.replay.SessionClock;
import org.sami.ui.value.WrappedText;

/** Says below a mission's head that it cannot go on, since when, why and what would help, and has what failed sent again. Not seen while it goes on. */
final class StuckBar extends JPanel {
    private final WrappedText text = new WrappedText("");
    private final CommandButton again;

    StuckBar(CommandRegistry commands) {
        super(new MigLayout("novisualpadding, insets 6 12 6 12, gap 8 4, fillx, hidemode 3", "[grow,fill][]"));
        setName("mission-stuck");
        text.setName("mission-stuck-text");
        again = new CommandButton(commands.get("mission-send-again"));
        add(text, "wmin 60");
        add(again);
        LookColors.background(this, SemanticColor.SURFACE_RAISED);
        LookColors.border(
                this, () -> BorderFactory.createMatteBorder(0, Look.px(6), 0, 0, SemanticColor.WARNING_FILL.get()));
        setVisible(false);
    }

    /** Since when it is stuck, and why. */
    static String what(StuckMission stuck) {
        return "Stuck since " + SessionClock.text(stuck.sinceMillis()) + ": " + stuck.what() + ".";
    }

    /** Says why. */
    void show(StuckMission stuck) {
        text.setText(what(stuck) + "\n" + stuck.help() + ".");
        again.setVisible(stuck.canBeSentAgain());
    }
}
