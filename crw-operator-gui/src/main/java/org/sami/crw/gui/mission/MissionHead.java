package org.sami.crw.gui.mission;

import java.awt.Dimension;
import java.util.List;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.sami.crw.operator.mission.StuckMission;
import org.sami.palette.SemanticColor;
import org.sami.ui.command.CommandButton;
import org.sami.ui.command.CommandRegistry;
import org.sami.ui.command.CommandRow;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;

/** What a mission does, and the buttons that end it: a line above its parts, or, where the panel is low, icons next to their tabs. */
final class MissionHead {
    private static final List<String> ENDING = List.of("mission-complete", "mission-abort");
    private static final String CLOSING = "mission-close";
    private static final int BRIEF = 160; // of it, and what the tabs leave
    private static final String SUB_MISSION = "mission-sub-mission";

    private final JLabel state = new JLabel();
    private final CommandRow line = new CommandRow();
    private final JPanel icons =
            new JPanel(new MigLayout("novisualpadding, insets 0, gap 0, fillx, hidemode 3", "8[grow,fill][][][][][]"));
    private final List<CommandButton> ending;
    private final CommandButton subMission;
    private final CommandButton sendAgain;
    private final JLabel brief = new JLabel();

    MissionHead(CommandRegistry commands) {
        state.setName("mission-state");
        line.left(state);
        ENDING.forEach(id -> line.right(new CommandButton(commands.get(id))));
        line.right(new CommandButton(commands.get(CLOSING)));
        icons.setOpaque(false);
        ending = ENDING.stream().map(id -> icon(commands, id)).toList();
        subMission = icon(commands, SUB_MISSION);
        sendAgain = icon(commands, "mission-send-again");
        brief.setName("mission-stuck-brief");
        LookColors.foreground(brief, SemanticColor.WARNING);
        brief.setFont(Fonts.strong());
        icons.add(brief, "wmin 0");
        icons.add(sendAgain);
        icons.add(subMission);
        ending.forEach(icons::add);
        icons.add(icon(commands, CLOSING));
        setLow(false);
        setNarrow(false);
        needSubMissions(false);
        showStuck(Optional.empty());
    }

    private static CommandButton icon(CommandRegistry commands, String id) {
        CommandButton icon = CommandButton.iconOnly(commands.get(id));
        icon.setName(id + "-icon");
        return icon;
    }

    JComponent line() {
        return line;
    }

    JComponent icons() {
        return icons;
    }

    /** Shows it as icons, or as a line. */
    void setLow(boolean low) {
        line.setVisible(!low);
        icons.setVisible(low);
    }

    /** Leaves the icons their words where there is room for them next to the tabs. */
    void setNarrow(boolean narrow) {
        ending.forEach(button -> button.setHideActionText(narrow));
    }

    boolean isLow() {
        return icons.isVisible();
    }

    /** Shows next to the tabs of a low panel that it cannot go on; the tooltip has the whole text. */
    void showStuck(Optional<StuckMission> stuck) {
        brief.setText(stuck.map(one -> "Stuck: " + one.what()).orElse(""));
        brief.setToolTipText(
                stuck.map(one -> StuckBar.what(one) + " " + one.help() + ".").orElse(null));
        brief.setFont(Fonts.strong());
        brief.setPreferredSize(
                stuck.isPresent()
                        ? new Dimension(
                                Look.px(BRIEF),
                                brief.getFontMetrics(brief.getFont()).getHeight())
                        : new Dimension());
        sendAgain.setVisible(stuck.filter(StuckMission::canBeSentAgain).isPresent());
    }

    /** Whether the icons begin with the one that lets a sub-mission be chosen. */
    void needSubMissions(boolean needed) {
        subMission.setVisible(needed);
    }

    /** Says what the mission does. */
    void show(String text, boolean ended, boolean stuck) {
        state.setText(text);
        state.setToolTipText(text);
        state.setFont(Fonts.strong());
        LookColors.foreground(state, ended ? SemanticColor.MUTED : stuck ? SemanticColor.WARNING : SemanticColor.OK);
        for (JComponent row : List.of(line, icons)) {
            for (var child : row.getComponents()) {
                if (child instanceof CommandButton button && button != subMission && button != sendAgain) {
                    button.setVisible(button.getName().startsWith(CLOSING) == ended);
                }
            }
        }
    }
}
