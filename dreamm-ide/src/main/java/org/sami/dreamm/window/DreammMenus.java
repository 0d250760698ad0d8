package org.sami.dreamm.window;

import java.util.List;
import javax.swing.JMenuBar;
import org.sami.ui.command.CommandRegistry;
import org.sami.ui.dock.DockPanel;
import org.sami.ui.window.CommandMenus;

/** The menus: every command of the window, by what it is about. */
final class DreammMenus {
    private DreammMenus() {}

    static JMenuBar bar(CommandRegistry commands, List<DockPanel> panels) {
        CommandMenus menus = new CommandMenus(commands);
        JMenuBar bar = new JMenuBar();
        bar.setName("menus");
        bar.add(menus.menu("File", 'F', "end"));
        bar.add(menus.menu("Edit", 'E', "undo", "redo"));
        bar.add(menus.view(panels));
        bar.add(menus.help());
        return bar;
    }
}
