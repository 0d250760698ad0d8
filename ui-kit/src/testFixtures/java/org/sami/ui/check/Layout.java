package org.sami.ui.check;

import java.awt.Component;
import java.awt.Container;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.JSplitPane;
import javax.swing.JTable;
import org.sami.palette.SemanticColor;

/** Lays components out and paints them without a window, so that it can be done where there is no display. */
public final class Layout {
    private static final int MOST_PASSES = 4; // a text that wraps says its height only after it has a width

    private Layout() {}

    /** Gives a component a size and lays out all that is in it. */
    public static void layOut(Container root, int width, int height) {
        hasMoved(root, width, height);
    }

    /**
     * Gives a component a size and lays out all that is in it, until a pass leaves everything where it was.
     *
     * @return whether anything has moved
     */
    public static boolean hasMoved(Container root, int width, int height) {
        List<Integer> before = arrangement(root);
        boolean moved = false;
        for (int i = 0; i < MOST_PASSES; i++) {
            root.setSize(width, height);
            invalidate(root);
            layOut(root);
            List<Integer> after = arrangement(root);
            if (after.equals(before)) {
                return moved;
            }
            moved = true;
            before = after;
        }
        return moved;
    }

    /** Where everything is, with what is arranged within tables and by dividers without any component that moves. */
    private static List<Integer> arrangement(Container root) {
        List<Integer> arrangement = new ArrayList<>();
        addArrangement(root, arrangement);
        return arrangement;
    }

    private static void addArrangement(Component component, List<Integer> arrangement) {
        arrangement.addAll(List.of(
                component.getX(),
                component.getY(),
                component.getWidth(),
                component.getHeight(),
                component.isVisible() ? 1 : 0));
        if (component instanceof JTable table) {
            for (int row = 0; row < table.getRowCount(); row++) {
                arrangement.add(table.getRowHeight(row));
            }
            Collections.list(table.getColumnModel().getColumns()).forEach(column -> arrangement.add(column.getWidth()));
        }
        if (component instanceof JSplitPane split) {
            arrangement.add(split.getDividerLocation());
        }
        if (component instanceof Container container) {
            for (Component child : container.getComponents()) {
                addArrangement(child, arrangement);
            }
        }
    }

    /** Gives a component a width and the height that it wants at that width. */
    public static void layOut(Container root, int width) {
        int height = root.getPreferredSize().height;
        for (int i = 0; i < MOST_PASSES && hasMoved(root, width, height); i++) {
            height = root.getPreferredSize().height;
        }
        layOut(root, width, height);
    }

    private static void invalidate(Component component) {
        component.invalidate();
        if (component instanceof Container container) {
            for (Component child : container.getComponents()) {
                invalidate(child);
            }
        }
    }

    private static void layOut(Container container) {
        container.doLayout();
        for (Component child : container.getComponents()) {
            if (child instanceof Container inner) {
                layOut(inner);
            }
        }
    }

    /** Paints a component that is laid out, on the surface of the theme in force. */
    public static BufferedImage paint(JComponent root) {
        BufferedImage image = new BufferedImage(
                Math.max(1, root.getWidth()), Math.max(1, root.getHeight()), BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.setColor(SemanticColor.SURFACE.get());
        g.fillRect(0, 0, image.getWidth(), image.getHeight());
        root.print(g);
        g.dispose();
        return image;
    }

    /** The component of a name below another, as a test tool would look for it. */
    public static <T extends Component> Optional<T> find(Container root, String name, Class<T> type) {
        for (Component child : root.getComponents()) {
            if (name.equals(child.getName()) && type.isInstance(child)) {
                return Optional.of(type.cast(child));
            }
            if (child instanceof Container inner) {
                Optional<T> found = find(inner, name, type);
                if (found.isPresent()) {
                    return found;
                }
            }
        }
        return Optional.empty();
    }
}
