package org.sami.crw.gui.window;

import java.awt.Dimension;
import java.util.List;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import org.sami.crw.fleet.RobotKind;
import org.sami.ui.command.CommandRegistry;
import org.sami.ui.dock.DockPanel;
import org.sami.ui.look.Look;
import org.sami.ui.look.Spacing;
import org.sami.ui.window.CommandMenus;

/** The menus: every command of the window, by what it is about. */
public final class WindowMenus {
    private static final int BORDER = 2; // above and below the menus

    private final RobotKind robots;
    private final CommandMenus menus;
    private final List<DockPanel> panels;

    /** The menus of a window on robots of a kind. */
    public WindowMenus(CommandRegistry commands, List<DockPanel> panels, RobotKind robots) {
        this.robots = robots;
        menus = new CommandMenus(commands);
        this.panels = panels;
    }

    /** The bar of a window over a session, or over its replay. */
    public JMenuBar bar() {
        JMenuBar bar = new JMenuBar() {
            @Override
            public Dimension getPreferredSize() {
                Dimension size = super.getPreferredSize();
                return new Dimension(size.width, Math.max(size.height, Look.px(Spacing.HIT_TARGET_FIELD) + BORDER));
            }
        };
        bar.setName("menus");
        bar.add(menus.menu("Session", 'S', "project-open", "globals-save", "replay-open", "", "end"));
        bar.add(menus.menu(
                "Mission",
                'M',
                "mission-start",
                "mission-start-with",
                "",
                "mission-send-again",
                "mission-complete",
                "mission-abort",
                "mission-end-confirm",
                "mission-end-leave",
                "mission-close",
                "",
                "mission-sub-mission",
                "mission-show-ended",
                "plans-find"));
        bar.add(menus.menu(
                robots.say("Boats"),
                robots.say("Boats").charAt(0),
                "boats-near",
                "boat-connect",
                "boat-pair",
                "phone-add",
                "keys",
                "boat-add-simulated",
                "boats-ground-station",
                "logs-fetch",
                "",
                "boat-stop",
                "boat-release",
                "boat-by-hand",
                "boat-take",
                "boat-hand-over",
                "boat-resend",
                "boat-cancel-command",
                "boat-clear-block",
                "boat-try-motor",
                "boat-disconnect",
                "address-give-up",
                "",
                "fleet-stop",
                "fleet-release",
                "fleet-release-confirm",
                "",
                "fault-boats"));
        bar.add(menus.menu("Notices", 'N', "message-acknowledge", "alarm-acknowledge", "alarm-mute", "alarm-sounds"));
        JMenu replay = menus.menu(
                "Replay",
                'R',
                "replay-play",
                "replay-step-back",
                "replay-step",
                "",
                "replay-mark-before",
                "replay-mark-next",
                "replay-start",
                "replay-end",
                "",
                "replay-faster",
                "replay-slower",
                "",
                "replay-message",
                "replay-decision");
        if (replay.getItemCount() > 0) { // over a session there is nothing to play
            bar.add(replay);
        }
        JMenu view = menus.view(panels);
        JMenu arrangements = menus.menu("Arrangement", 'A', "arrangement-first", "arrangement-aims");
        if (arrangements.getItemCount() > 0) { // a replay has one
            view.add(arrangements);
        }
        bar.add(view);
        bar.add(menus.help());
        return bar;
    }
}
