package org.sami.dreamm.window;

import java.util.List;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import org.sami.dreamm.file.FileCommands;
import org.sami.dreamm.file.RecentMenu;
import org.sami.ui.command.CommandRegistry;
import org.sami.ui.dock.DockPanel;
import org.sami.ui.window.CommandMenus;

/** The menus: every command of the window, by what it is about. */
final class DreammMenus {
    private DreammMenus() {}

    static JMenuBar bar(CommandRegistry commands, FileCommands files, List<DockPanel> panels) {
        CommandMenus menus = new CommandMenus(commands);
        JMenuBar bar = new JMenuBar();
        bar.setName("menus");
        JMenu file = menus.menu("File", 'F', "project-new", "project-open", "library-open");
        file.add(RecentMenu.of(files));
        menus.add(
                file,
                "",
                "project-save",
                "project-save-as",
                "project-save-folder",
                "",
                "import-legacy",
                "import-geometry",
                "",
                "end");
        bar.add(file);
        bar.add(menus.menu("Edit", 'E', "undo", "redo", "", "rename", "usages-find", "search-everything"));
        bar.add(menus.menu(
                "Plan", 'P', "plan-new", "plan-clone", "tree-delete", "", "folder-new", "plan-up", "plan-down"));
        bar.add(menus.view(panels));
        bar.add(menus.help());
        return bar;
    }
}
