package org.sami.ui.window;

import java.util.List;
import java.util.Locale;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import org.sami.ui.command.Command;
import org.sami.ui.command.CommandRegistry;
import org.sami.ui.dock.DockPanel;

/** Makes menus of commands. Commands that a window lacks are left out. On the event thread. */
public final class CommandMenus {
    private final CommandRegistry commands;

    /** Menus of a window's commands. */
    public CommandMenus(CommandRegistry commands) {
        this.commands = commands;
    }

    /**
     * A menu.
     *
     * @param ids of commands; an empty text is a line between groups
     */
    public JMenu menu(String title, char mnemonic, String... ids) {
        JMenu menu = new JMenu(title);
        menu.setName("menu-" + title.toLowerCase(Locale.ROOT));
        menu.setMnemonic(mnemonic);
        add(menu, ids);
        return menu;
    }

    /** Adds commands at the end of a menu. */
    public void add(JMenu menu, String... ids) {
        for (String id : ids) {
            if (!id.isEmpty()) {
                commands.find(id).filter(command -> !command.isHidden()).ifPresent(command -> menu.add(item(command)));
            } else if (menu.getItemCount() > 0 && menu.getItem(menu.getItemCount() - 1) != null) {
                menu.addSeparator();
            }
        }
    }

    /** The menu of {@link ViewCommands}: themes, scale, panels. */
    public JMenu view(List<DockPanel> panels) {
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
                "rows-high",
                "");
        panels.forEach(panel -> add(view, "panel-" + panel.getPersistentID()));
        add(view, "", "panels-reset");
        return view;
    }

    /** The menu of help. */
    public JMenu help() {
        return menu("Help", 'H', "command-search", "help-keys");
    }

    private static JMenuItem item(Command command) {
        JMenuItem item = new JMenuItem(command);
        item.setName("menu-" + command.id());
        if (command.isTyped()) {
            item.setAccelerator(null); // the menu would take it from the text of a field
        }
        return item;
    }
}
