package org.sami.dreamm.file;

import java.nio.file.Path;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.event.MenuEvent;
import javax.swing.event.MenuListener;

/** The menu of projects that were opened last, made again each time that it is shown. */
public final class RecentMenu {
    private RecentMenu() {}

    /** The menu. */
    public static JMenu of(FileCommands files) {
        JMenu menu = new JMenu("Open recent");
        menu.setName("menu-recent");
        menu.setMnemonic('R');
        menu.addMenuListener(new MenuListener() {
            @Override
            public void menuSelected(MenuEvent e) {
                fill(menu, files);
            }

            @Override
            public void menuDeselected(MenuEvent e) {
                // it stays as it is
            }

            @Override
            public void menuCanceled(MenuEvent e) {
                // it stays as it is
            }
        });
        fill(menu, files);
        return menu;
    }

    private static void fill(JMenu menu, FileCommands files) {
        menu.removeAll();
        int number = 1;
        for (Path path : files.recent()) {
            JMenuItem item = new JMenuItem(number + "  " + path);
            item.setName("recent-" + number);
            item.setMnemonic('0' + number);
            item.addActionListener(e -> files.open(path));
            menu.add(item);
            number++;
        }
        if (number == 1) {
            JMenuItem none = new JMenuItem("No project was opened yet");
            none.setEnabled(false);
            menu.add(none);
        }
    }
}
