package org.sami.crw.gui.window;

import java.util.List;
import java.util.Locale;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import org.sami.ui.command.Command;
import org.sami.ui.command.CommandRegistry;
import org.sami.ui.dock.DockPanel;

/** The menus: every command of the window, by what it is about. */
public final class WindowMenus {
    private final CommandRegistry commands;
    private final List<DockPanel> panels;

    /** The menus of a window. */
    public WindowMenus(CommandRegistry commands, List<DockPanel> panels) {
        this.commands = commands;
        this.panels = panels;
    }

    /** The bar of a window over a session. */
    public JMenuBar bar() {
        JMenuBar bar = new JMenuBar();
        bar.setName("menus");
        bar.add(menu("Session", 'S', "project-open", "globals-save", "replay-open", "", "end"));
        bar.add(menu(
                "Mission",
                'M',
                "mission-start",
                "mission-start-with",
                "",
                "mission-complete",
                "mission-abort",
                "mission-end-confirm",
                "mission-end-leave",
                "mission-close"));
        bar.add(menu(
                "Boats",
                'B',
                "boat-connect",
                "",
                "boat-stop",
                "boat-release",
                "boat-by-hand",
                "boat-take",
                "boat-hand-over",
                "boat-resend",
                "boat-disconnect",
                "",
                "fleet-stop",
                "fleet-release",
                "fleet-release-confirm"));
        bar.add(menu("Notices", 'N', "message-acknowledge", "alarm-acknowledge", "alarm-mute"));
        JMenu view = menu(
                "View",
                'V',
                "theme-light",
                "theme-dark",
                "theme-sun",
                "",
                "scale-larger",
                "scale-smaller",
                "scale-reset",
                "");
        panels.forEach(panel -> view.add(item("panel-" + panel.getPersistentID())));
        view.addSeparator();
        view.add(item("panels-reset"));
        bar.add(view);
        bar.add(menu("Help", 'H', "command-search", "help-keys"));
        return bar;
    }

    private JMenu menu(String title, char mnemonic, String... ids) {
        JMenu menu = new JMenu(title);
        menu.setName("menu-" + title.toLowerCase(Locale.ROOT));
        menu.setMnemonic(mnemonic);
        for (String id : ids) {
            if (id.isEmpty()) {
                menu.addSeparator();
            } else if (commands.find(id).isPresent()) { // a replay lacks some
                menu.add(item(id));
            }
        }
        return menu;
    }

    private JMenuItem item(String id) {
        Command command = commands.get(id);
        JMenuItem item = new JMenuItem(command);
        item.setName("menu-" + id);
        return item;
    }
}
