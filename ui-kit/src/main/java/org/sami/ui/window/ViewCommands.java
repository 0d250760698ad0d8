package org.sami.ui.window;

import javax.swing.JFrame;
import org.sami.palette.Theme;
import org.sami.ui.command.Command;
import org.sami.ui.command.CommandKeysPanel;
import org.sami.ui.command.CommandRegistry;
import org.sami.ui.command.CommandSearch;
import org.sami.ui.dock.DockArea;
import org.sami.ui.dock.DockPanel;
import org.sami.ui.look.Look;

/** The commands of how a window looks: themes and scale, panels, help. */
public final class ViewCommands {
    private static final int DIGITS = 10;

    private final CommandRegistry commands;
    private final WindowSettings settings;

    /** The commands of a window's looks. */
    public ViewCommands(CommandRegistry commands, JFrame frame, WindowSettings settings) {
        this.commands = commands;
        this.settings = settings;
        int digit = 1;
        for (Theme theme : Theme.values()) {
            add(new Command("theme-" + theme.id(), "Theme: " + theme.title(), () -> look(theme, Look.scalePercent()))
                    .withKey("ctrl shift " + digit++)
                    .withIcon("theme"));
        }
        add(new Command("scale-larger", "Larger text", () -> look(Look.theme(), Look.nextScale(true)))
                .withKey("ctrl EQUALS")
                .withIcon("zoom-in"));
        add(new Command("scale-smaller", "Smaller text", () -> look(Look.theme(), Look.nextScale(false)))
                .withKey("ctrl MINUS")
                .withIcon("zoom-out"));
        add(new Command("scale-reset", "Text of 100 %", () -> look(Look.theme(), 100)).withKey("ctrl 0"));
        add(new Command("rows-high", "High rows on or off", () -> {
                    Look.setHighRows(!Look.hasHighRows());
                    look(Look.theme(), Look.scalePercent());
                })
                .withKey("ctrl shift " + digit)
                .withIcon("hand"));
        add(new Command("command-search", "Find a command…", () -> CommandSearch.open(frame, commands))
                .withKey("ctrl shift P")
                .withIcon("search"));
        add(new Command("help-keys", "Commands and keys", () -> CommandKeysPanel.open(frame, commands))
                .withKey("F1")
                .withIcon("keyboard"));
    }

    private void add(Command command) {
        commands.add(command);
    }

    private void look(Theme theme, int scale) {
        Look.apply(theme, scale);
        settings.keepLook();
    }

    /** A command for each panel, with Alt and a digit (from the eleventh on with Shift as well), and one that puts all back. */
    public void addPanels(DockArea dock) {
        int number = 1;
        for (DockPanel panel : dock.panels()) {
            String id = panel.getPersistentID();
            add(new Command("panel-" + id, "Show " + panel.title(), () -> dock.show(id))
                    .withKey((number > DIGITS ? "alt shift " : "alt ") + number % DIGITS));
            dock.setKey(id, commands.get("panel-" + id).keyText());
            number++;
        }
        add(new Command("panels-reset", "Put all panels back", dock::reset)
                .withKey("alt HOME")
                .withIcon("layout"));
    }
}
