package org.sami.ui.replay;

import java.util.List;
import java.util.Locale;
import javax.swing.BorderFactory;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import net.miginfocom.swing.MigLayout;
import org.sami.palette.SemanticColor;
import org.sami.spn.replay.Playback;
import org.sami.ui.command.Command;
import org.sami.ui.command.CommandButton;
import org.sami.ui.command.CommandRegistry;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.LookColors;

/** The time line at the foot of a replay, and the commands that move on it. */
public final class TimeLinePanel extends JPanel {
    /** Where the keys of a time line's commands work. */
    public enum Keys {
        /** In the whole window, unless what has the focus has a use for them. */
        WINDOW,
        /** In the time line when it has the focus: the window needs them for something else. */
        FOCUS
    }

    private final transient PlaybackTimer player;
    private final Keys keys;
    private final TimeLineBar bar;
    private final JLabel time = new JLabel();
    private final JComboBox<String> speeds = new JComboBox<>();
    private final CommandButton play;

    /**
     * A panel over a player, whose commands it adds.
     *
     * @param keys where the keys of its commands work
     */
    public TimeLinePanel(PlaybackTimer player, CommandRegistry commands, Keys keys) {
        super(new MigLayout("insets 4 12 4 12, gap 8", "[][][][][][][grow]", "[]"));
        this.player = player;
        this.keys = keys;
        bar = new TimeLineBar(player);
        setName("time-line-panel");
        play = new CommandButton(
                commands.add(command("replay-play", "Play or pause", "SPACE", "play", player::toggle)));
        Command before = command("replay-step-back", "One step back", "LEFT", "left", () -> player.step(false));
        Command after = command("replay-step", "One step on", "RIGHT", "right", () -> player.step(true));
        add(CommandButton.iconOnly(commands.add(before)));
        add(play);
        add(CommandButton.iconOnly(commands.add(after)));
        commands.add(
                command("replay-mark-before", "To the mark before", "ctrl LEFT", "left", () -> player.toMark(false)));
        commands.add(command("replay-mark-next", "To the next mark", "ctrl RIGHT", "right", () -> player.toMark(true)));
        commands.add(command("replay-start", "To the start", "HOME", "left", () -> player.goTo(0)));
        commands.add(command(
                "replay-end",
                "To the end",
                "END",
                "right",
                () -> player.goTo(player.timeLine().endMillis())));
        commands.add(command("replay-faster", "Faster", "ctrl UP", "up", () -> player.change(true)));
        commands.add(command("replay-slower", "Slower", "ctrl DOWN", "down", () -> player.change(false)));
        for (double speed : Playback.SPEEDS) {
            speeds.addItem(words(speed));
        }
        speeds.setName("replay-speed");
        speeds.setToolTipText("How many times as fast as it happened (Ctrl+Up, Ctrl+Down)");
        speeds.getAccessibleContext().setAccessibleName("Speed");
        speeds.setFocusable(false);
        speeds.addActionListener(e -> player.setSpeed(Playback.SPEEDS.get(speeds.getSelectedIndex())));
        add(speeds, "hmin 40");
        time.setName("replay-time");
        add(time, "wmin pref");
        add(bar, "growx, wmin 0, span");
        player.addListener(this::refresh);
        style();
        refresh();
    }

    private Command command(String id, String title, String key, String icon, Runnable run) {
        Command command = new Command(id, title, run).withIcon(icon);
        if (keys == Keys.WINDOW) {
            return command.withKey(key);
        }
        command.withFocusKeys(List.of(KeyStroke.getKeyStroke(key))).bindTo(bar);
        return command;
    }

    private static String words(double speed) {
        return speed < 1 ? String.format(Locale.ROOT, "%.2f x", speed) : String.format(Locale.ROOT, "%.0f x", speed);
    }

    /** Has the keys of the time line go to it. */
    public void focus() {
        bar.requestFocusInWindow();
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (time != null) {
            style();
        }
    }

    private void style() {
        LookColors.background(this, SemanticColor.SURFACE);
        LookColors.border(this, () -> BorderFactory.createMatteBorder(1, 0, 0, 0, SemanticColor.BORDER.get()));
        time.setFont(Fonts.heading());
    }

    private void refresh() {
        Playback playback = player.playback();
        time.setText(SessionClock.text(playback.atMillis()) + " / "
                + SessionClock.text(player.timeLine().endMillis()));
        int index = Playback.SPEEDS.indexOf(playback.speed());
        if (speeds.getSelectedIndex() != index) {
            speeds.setSelectedIndex(index);
        }
        play.setText(playback.isPlaying() ? "Pause" : "Play");
    }
}
