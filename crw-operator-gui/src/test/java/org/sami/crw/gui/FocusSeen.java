package org.sami.crw.gui;

import java.awt.Component;
import java.awt.Container;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import javax.swing.JComponent;
import javax.swing.JRootPane;
import javax.swing.LayoutFocusTraversalPolicy;
import javax.swing.SwingUtilities;
import org.sami.ui.check.Layout;
import org.sami.ui.check.WindowRobot;

/** Gives the keyboard's focus to each component of a window in turn, and looks whether that changes its picture. Not for the event thread. */
final class FocusSeen {
    private static final int LEAST_PIXELS = 12;
    private static final int AROUND = 3;

    private final JRootPane root;
    private final WindowRobot robot;
    private final Set<String> looked = new HashSet<>();
    private final List<String> unseen = new ArrayList<>();

    FocusSeen(JRootPane root, WindowRobot robot) {
        this.root = root;
        this.robot = robot;
    }

    /** What looked the same with the focus as without it. */
    List<String> unseen() {
        return List.copyOf(unseen);
    }

    /** Looks at all that can have the focus now, at each kind and name once. */
    void look() {
        for (JComponent part : WindowRobot.ask(this::parts)) {
            String name = part.getClass().getSimpleName() + " " + part.getName();
            Optional<BufferedImage> before = looked.contains(name) ? Optional.empty() : unfocused(part);
            if (before.isPresent()) {
                looked.add(name);
                WindowRobot.ask(part::requestFocusInWindow);
                robot.until(name + " has the focus", 10, () -> part.isFocusOwner() || !part.isShowing());
                if (differing(before.get(), picture(part)) < LEAST_PIXELS && WindowRobot.ask(part::isFocusOwner)) {
                    unseen.add(name);
                }
            }
        }
    }

    private List<JComponent> parts() {
        List<JComponent> parts = new ArrayList<>();
        collect(root, parts);
        return parts;
    }

    private static void collect(Container at, List<JComponent> parts) {
        for (Component child : at.getComponents()) {
            if (child.isVisible() && child instanceof JComponent part) {
                if (Traversal.TAKES.takes(part)
                        && !part.isFocusOwner()
                        && !part.getVisibleRect().isEmpty()) {
                    parts.add(part);
                }
                collect(part, parts);
            }
        }
    }

    /** Its picture without the focus; empty where it is not seen, or has got the focus meanwhile from a part that went away: another look comes to it. */
    private Optional<BufferedImage> unfocused(JComponent part) {
        return WindowRobot.ask(
                () -> part.isShowing() && !part.isFocusOwner() ? Optional.of(picture(part)) : Optional.empty());
    }

    private BufferedImage picture(JComponent part) {
        return WindowRobot.ask(() -> {
            Rectangle seen = SwingUtilities.convertRectangle(part, part.getVisibleRect(), root);
            seen.grow(AROUND, AROUND);
            Rectangle inside = seen.intersection(new Rectangle(root.getSize()));
            BufferedImage all = Layout.paint(root);
            return inside.isEmpty()
                    ? new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB)
                    : all.getSubimage(inside.x, inside.y, inside.width, inside.height);
        });
    }

    private static int differing(BufferedImage a, BufferedImage b) {
        int differing = 0;
        for (int y = 0; y < Math.min(a.getHeight(), b.getHeight()); y++) {
            for (int x = 0; x < Math.min(a.getWidth(), b.getWidth()); x++) {
                if (a.getRGB(x, y) != b.getRGB(x, y)) {
                    differing++;
                }
            }
        }
        return differing;
    }

    /** What the Tab key comes to. */
    private static final class Traversal extends LayoutFocusTraversalPolicy {
        private static final Traversal TAKES = new Traversal();

        boolean takes(Component component) {
            return accept(component);
        }
    }
}
