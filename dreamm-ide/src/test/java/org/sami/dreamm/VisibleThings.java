package org.sami.dreamm;

import java.awt.Component;
import java.awt.Container;
import java.awt.Window;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import javax.swing.AbstractButton;
import javax.swing.JComboBox;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;
import javax.swing.text.JTextComponent;
import org.sami.dreamm.palette.PaletteItem;
import org.sami.dreamm.profile.ProfileGuard;
import org.sami.dreamm.profile.ProfileIds;
import org.sami.ui.check.WindowRobot;
import org.sami.ui.command.Command;

/**
 * What of the editor a person can see and use now, read from the component tree: entries of menus, items of palettes, fields of panels, and what
 * their choices offer. What can be seen and not be used is left out.
 */
final class VisibleThings {
    /** Of choices, whose words count: by the beginning of their names. */
    private static final Map<String, String> CHOICES = Map.of(
            "inspector-kind-", "kind:",
            "inspector-match-", "match:",
            "inspector-action-", "action:",
            "inspector-quantity-", "quantity:",
            "field-", "source:");

    private final Set<String> things = new LinkedHashSet<>();

    private VisibleThings() {}

    /** All of them. */
    static Set<String> now() {
        return WindowRobot.ask(() -> {
            VisibleThings visible = new VisibleThings();
            for (Window window : Window.getWindows()) {
                if (window.isShowing()) {
                    if (window instanceof JFrame frame && frame.getJMenuBar() != null) {
                        for (Component menu : frame.getJMenuBar().getComponents()) {
                            visible.menu(menu);
                        }
                    }
                    visible.collect(window);
                }
            }
            return visible.things;
        });
    }

    /** The commands in the menus that can be given at this moment. */
    static Set<String> commandsNow() {
        return WindowRobot.ask(() -> {
            Set<String> ids = new TreeSet<>();
            for (Window window : Window.getWindows()) {
                if (window.isShowing() && window instanceof JFrame frame && frame.getJMenuBar() != null) {
                    for (Component menu : frame.getJMenuBar().getComponents()) {
                        enabled(menu, ids);
                    }
                }
            }
            return ids;
        });
    }

    private static void enabled(Component entry, Set<String> ids) {
        if (entry instanceof JMenu menu) {
            for (Component each : menu.getMenuComponents()) {
                enabled(each, ids);
            }
        } else if (entry instanceof JMenuItem item && item.getAction() instanceof Command command && item.isEnabled()) {
            ids.add(command.id());
        }
    }

    /** What can be changed in the inspector at this moment: the names of its fields, boxes and buttons. */
    static Set<String> inspectorNow() {
        return WindowRobot.ask(() -> {
            Set<String> names = new TreeSet<>();
            for (Window window : Window.getWindows()) {
                inspector(window, false, names);
            }
            return names;
        });
    }

    private static void inspector(Component at, boolean inside, Set<String> names) {
        boolean within = inside || "inspector-panel".equals(at.getName());
        boolean used = at instanceof AbstractButton
                || at instanceof JTextComponent
                || at instanceof JComboBox<?>
                || at instanceof JList<?>;
        if (within && used && at.isShowing() && at.getName() != null) {
            names.add(at.getName());
        }
        if (at instanceof Container container) {
            for (Component child : container.getComponents()) {
                inspector(child, within, names);
            }
        }
    }

    private void menu(Component entry) {
        if (entry instanceof JMenu menu) {
            for (Component each : menu.getMenuComponents()) {
                menu(each);
            }
        } else if (entry instanceof JMenuItem item && item.getAction() instanceof Command command) {
            if (isGiven(command)) {
                things.add("menu:" + command.id());
            }
        }
    }

    /** Whether nothing but the moment keeps a command from being used. */
    private static boolean isGiven(Command command) {
        return command.whyNot().filter(why -> why.startsWith("the profile ")).isEmpty();
    }

    private void collect(Component at) {
        if (!at.isShowing()) {
            return;
        }
        String id = ProfileGuard.idOf(at);
        if (ProfileIds.fixed().contains(id) && at.isEnabled()) {
            things.add(id);
        }
        if (at instanceof JList<?> list
                && ("palette-list".equals(list.getName()) || "inspector-events-list".equals(list.getName()))) {
            palette(list);
        } else if (at instanceof JComboBox<?> box) {
            choice(box);
        } else if (at instanceof JPopupMenu popup && "net-menu".equals(popup.getName())) {
            for (Component entry : popup.getComponents()) {
                menu(entry);
            }
        }
        if (at instanceof Container container) {
            for (Component child : container.getComponents()) {
                collect(child);
            }
        }
    }

    private void palette(JList<?> list) {
        for (int i = 0; i < list.getModel().getSize(); i++) {
            Object row = list.getModel().getElementAt(i);
            if (row instanceof PaletteItem item) {
                things.add(
                        item instanceof PaletteItem.Event event
                                ? "event:" + event.type().name()
                                : item.id());
            } else {
                things.add(row.toString().replaceAll("(?s).*?id=([^,]*),.*", "$1"));
            }
        }
    }

    private <T> void choice(JComboBox<T> box) {
        String name = box.getName() == null ? "" : box.getName();
        Optional<String> kind = CHOICES.keySet().stream()
                .filter(name::startsWith)
                .filter(beginning -> !beginning.equals("field-") || name.endsWith("-source"))
                .findFirst();
        kind.map(CHOICES::get).ifPresent(prefix -> {
            for (int i = 0; i < box.getItemCount(); i++) {
                things.add(prefix + words(box, i));
            }
        });
        if (name.equals("event-add-markup")) {
            for (int i = 1; i < box.getItemCount(); i++) {
                things.add("markup:" + box.getItemAt(i));
            }
        }
    }

    private static <T> String words(JComboBox<T> box, int i) {
        Component cell =
                box.getRenderer().getListCellRendererComponent(new JList<>(), box.getItemAt(i), i, false, false);
        return cell instanceof JLabel label ? String.valueOf(label.getText()) : "";
    }
}
