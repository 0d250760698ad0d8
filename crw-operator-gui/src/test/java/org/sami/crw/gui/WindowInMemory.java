package org.sami.crw.gui;

import java.awt.Component;
import java.awt.Container;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import javax.swing.JFrame;
import javax.swing.JRootPane;
import javax.swing.JTabbedPane;
import org.sami.crw.gui.window.OperatorWindow;
import org.sami.palette.Theme;
import org.sami.ui.check.Layout;
import org.sami.ui.check.TextFit;
import org.sami.ui.check.WindowRobot;
import org.sami.ui.dock.DockPanel;
import org.sami.ui.look.Look;

/** Lays out and paints a window that is open, with all its panels, in looks and at sizes that its screen need not have. */
final class WindowInMemory {
    private static final int MOST_ROUNDS =
            4; // panels that are arranged again, and dividers, hear of a size after its layout

    private final JFrame frame;

    WindowInMemory(OperatorWindow window) {
        this(window.frame());
    }

    WindowInMemory(JFrame frame) {
        this.frame = frame;
    }

    /** Gives it a look. */
    void look(Theme theme, int percent) {
        WindowRobot.ask(() -> {
            Look.apply(theme, percent);
            return null;
        });
    }

    /** Gives it a size. */
    void size(int width, int height) {
        boolean moved = true;
        for (int i = 0; i < MOST_ROUNDS && moved; i++) {
            moved = WindowRobot.ask(() -> Layout.hasMoved(root(), width, height));
        }
    }

    /** The ids of the panels that do not lie behind others. */
    List<String> panelsInSight() {
        return WindowRobot.ask(() -> panels(root()));
    }

    private static List<String> panels(Container container) {
        List<String> found = new ArrayList<>();
        for (Component child : container.getComponents()) {
            if (child instanceof DockPanel panel && panel.isVisible()) {
                found.add(panel.getPersistentID());
            } else if (child.isVisible() && child instanceof Container inner) {
                found.addAll(panels(inner));
            }
        }
        return found;
    }

    /** What is wrong with its texts, with each tab in front once; of tabs of one name in panes of one name, one. */
    List<String> textFaults() {
        Set<String> faults = new LinkedHashSet<>();
        Set<String> seen = new HashSet<>();
        while (WindowRobot.ask(() -> bringToFront(root(), seen))) {
            faults.addAll(WindowRobot.ask(() -> {
                Layout.layOut(root(), root().getWidth(), root().getHeight());
                return TextFit.faults(root());
            }));
        }
        return List.copyOf(faults);
    }

    /** Runs something on the event thread with each tab in front once, as it is laid out then. */
    void eachTab(Runnable look) {
        Set<String> seen = new HashSet<>();
        while (WindowRobot.ask(() -> bringToFront(root(), seen))) {
            WindowRobot.ask(() -> {
                Layout.layOut(root(), root().getWidth(), root().getHeight());
                look.run();
                return null;
            });
        }
    }

    /** Runs something, not on the event thread, with each tab in front once. */
    void betweenTabs(Runnable look) {
        Set<String> seen = new HashSet<>();
        while (WindowRobot.ask(() -> bringToFront(root(), seen))) {
            look.run();
        }
    }

    /** How it looks now. */
    BufferedImage picture() {
        return WindowRobot.ask(() -> Layout.paint(root()));
    }

    private JRootPane root() {
        return frame.getRootPane();
    }

    /** Brings tabs to the front that were not seen yet, one in each pane; false where there are none any longer. */
    private static boolean bringToFront(Container container, Set<String> seen) {
        boolean any = false;
        if (container instanceof JTabbedPane tabs) {
            int next = 0;
            while (next < tabs.getTabCount() && !hasUnseen(tabs, next, seen)) {
                next++;
            }
            if (next == tabs.getTabCount()) {
                return false;
            }
            tabs.setSelectedIndex(next);
            any = seen.add(key(tabs, next));
            boolean inner = tabs.getComponentAt(next) instanceof Container page && bringToFront(page, seen);
            return inner || any;
        }
        for (Component child : container.getComponents()) {
            if (child instanceof Container inner) {
                any |= bringToFront(inner, seen);
            }
        }
        return any;
    }

    private static boolean hasUnseen(JTabbedPane tabs, int index, Set<String> seen) {
        return !seen.contains(key(tabs, index))
                || (tabs.getComponentAt(index) instanceof Container page && hasUnseen(page, seen));
    }

    private static boolean hasUnseen(Container container, Set<String> seen) {
        if (container instanceof JTabbedPane tabs) {
            return IntStream.range(0, tabs.getTabCount()).anyMatch(index -> hasUnseen(tabs, index, seen));
        }
        return Arrays.stream(container.getComponents())
                .anyMatch(child -> child instanceof Container inner && hasUnseen(inner, seen));
    }

    private static String key(JTabbedPane tabs, int index) {
        return tabs.getName() + "/" + tabs.getTitleAt(index);
    }
}
