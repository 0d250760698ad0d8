package org.sami.ui.check;

import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Insets;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.List;
import javax.swing.AbstractButton;
import javax.swing.Icon;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JLayeredPane;
import javax.swing.JList;
import javax.swing.JTable;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import javax.swing.JTree;
import javax.swing.JViewport;
import javax.swing.SwingConstants;
import javax.swing.SwingUtilities;
import javax.swing.table.JTableHeader;
import javax.swing.table.TableCellRenderer;
import javax.swing.tree.TreePath;
import org.sami.ui.look.Look;

/**
 * Says which texts of a window are cut, too small, or lie on one another, as far as its components are laid out ({@link Layout}, or a window that is
 * shown). What scrolls is looked at in full: only what a scroll bar cannot bring to sight is cut.
 */
public final class TextFit {
    private static final int LEAST_PX = 12;
    private static final int SLACK_PX = 1;
    private static final int LEAST_SHORTENED = 12; // letters and dots

    private final List<String> faults = new ArrayList<>();
    private final int leastPx = Math.round(LEAST_PX * Look.scalePercent() / 100f);

    private TextFit() {}

    /** One sentence for each fault below a component, with the names of those that have it. */
    public static List<String> faults(Container root) {
        TextFit check = new TextFit();
        check.look(root);
        return check.faults;
    }

    private void look(Component component) {
        if (!component.isVisible()) {
            return;
        }
        if (component instanceof JLabel label) {
            checkLine(label, label.getText(), label.getIcon(), Look.px(label.getIconTextGap()));
        } else if (component instanceof AbstractButton button) {
            checkLine(button, button.getText(), button.getIcon(), button.getIconTextGap());
        } else if (component instanceof JTextArea area) {
            checkHeight(area);
        } else if (component instanceof JTextField field) {
            checkHeight(field);
        } else if (component instanceof JComboBox<?> box) {
            checkWidth(box);
            return; // its parts are its own
        } else if (component instanceof JTable table) {
            checkCells(table);
        } else if (component instanceof JList<?> list) {
            checkRows(list);
        } else if (component instanceof JTree tree) {
            checkRows(tree);
        }
        if (component instanceof Container container) {
            checkChildren(container);
            for (Component child : container.getComponents()) {
                look(child);
            }
        }
    }

    private void checkLine(JComponent component, String text, Icon icon, int gap) {
        if (text == null || text.isBlank()) {
            return;
        }
        FontMetrics metrics = component.getFontMetrics(component.getFont());
        checkSize(component, text, metrics);
        if (text.startsWith("<html>")) {
            checkHeight(component);
            return;
        }
        Insets insets = component.getInsets();
        Rectangle room = new Rectangle(
                insets.left,
                insets.top,
                component.getWidth() - insets.left - insets.right + SLACK_PX,
                component.getHeight() - insets.top - insets.bottom);
        String seen = SwingUtilities.layoutCompoundLabel(
                component,
                metrics,
                text,
                icon,
                SwingUtilities.CENTER,
                SwingUtilities.LEFT,
                SwingUtilities.CENTER,
                SwingUtilities.TRAILING,
                room,
                new Rectangle(),
                new Rectangle(),
                gap);
        int free = component.getHeight() + SLACK_PX;
        boolean whole = seen.equals(text) || isShortened(component, text, seen);
        if (!whole || free < metrics.getAscent() + metrics.getDescent()) {
            faults.add(nameOf(component) + " is cut: \"" + text + "\" in " + component.getWidth() + " x "
                    + component.getHeight() + " px");
        }
    }

    /** Whether a text of any length, not the name of a command, is shortened so that much of it is read, and the tooltip has all of it. */
    private static boolean isShortened(JComponent component, String text, String seen) {
        boolean fromOutside = component instanceof JLabel
                || (component instanceof AbstractButton button
                        && button.getHorizontalAlignment() == SwingConstants.LEADING);
        String tooltip = component.getToolTipText();
        return fromOutside && tooltip != null && tooltip.contains(text) && seen.length() > LEAST_SHORTENED;
    }

    private void checkSize(JComponent component, String text, FontMetrics metrics) {
        if (metrics.getFont().getSize2D() + 0.5f < leastPx) {
            faults.add(nameOf(component) + " is smaller than " + leastPx + " px: \"" + text + "\"");
        }
    }

    private void checkHeight(JComponent component) {
        Dimension wanted = component.getPreferredSize();
        if (component.getHeight() + SLACK_PX < wanted.height) {
            faults.add(nameOf(component) + " is " + component.getHeight() + " px high and needs " + wanted.height);
        }
    }

    private void checkWidth(JComponent component) {
        int wanted = component.getPreferredSize().width;
        if (component.getWidth() + SLACK_PX < wanted) {
            faults.add(nameOf(component) + " is " + component.getWidth() + " px wide and needs " + wanted);
        }
    }

    private void checkCells(JTable table) {
        checkHeads(table);
        for (int row = 0; row < table.getRowCount(); row++) {
            for (int column = 0; column < table.getColumnCount(); column++) {
                TableCellRenderer renderer = table.getCellRenderer(row, column);
                Dimension wanted = table.prepareRenderer(renderer, row, column).getPreferredSize();
                Rectangle cell = table.getCellRect(row, column, false);
                if (cell.width + SLACK_PX < wanted.width || cell.height + SLACK_PX < wanted.height) {
                    faults.add(nameOf(table) + " cuts row " + row + ", column " + column + ": \""
                            + table.getValueAt(row, column) + "\"");
                }
            }
        }
    }

    private <T> void checkRows(JList<T> list) {
        for (int row = 0; row < list.getModel().getSize(); row++) {
            Component cell = list.getCellRenderer()
                    .getListCellRendererComponent(list, list.getModel().getElementAt(row), row, false, false);
            Rectangle bounds = list.getCellBounds(row, row);
            checkRow(list, cell, bounds, row);
        }
    }

    private void checkRows(JTree tree) {
        for (int row = 0; row < tree.getRowCount(); row++) {
            TreePath path = tree.getPathForRow(row);
            boolean leaf = tree.getModel().isLeaf(path.getLastPathComponent());
            Component cell = tree.getCellRenderer()
                    .getTreeCellRendererComponent(
                            tree, path.getLastPathComponent(), false, tree.isExpanded(row), leaf, row, false);
            checkRow(tree, cell, tree.getRowBounds(row), row);
        }
    }

    /** A row of a list or tree is as wide as it wants to be; where it leaves something out, the tooltip says the whole. */
    private void checkRow(JComponent owner, Component cell, Rectangle bounds, int row) {
        int room = owner.getParent() instanceof JViewport viewport ? viewport.getWidth() : owner.getWidth();
        int wanted = bounds.x + cell.getPreferredSize().width;
        if (wanted > room + SLACK_PX || bounds.height + SLACK_PX < cell.getPreferredSize().height) {
            faults.add(nameOf(owner) + " cuts row " + row + ", which needs " + wanted + " x "
                    + cell.getPreferredSize().height + " px: " + bounds.width + " x " + bounds.height + " of " + room);
        }
        MouseEvent over = new MouseEvent(
                owner,
                MouseEvent.MOUSE_MOVED,
                0,
                0,
                bounds.x + bounds.width / 2,
                bounds.y + bounds.height / 2,
                0,
                false);
        String tip = owner.getToolTipText(over);
        texts(cell).stream()
                .filter(text -> text.contains("…") && (tip == null || tip.length() < text.length()))
                .forEach(text -> faults.add(nameOf(owner) + " has no tooltip that says the whole of \"" + text + "\""));
    }

    private static List<String> texts(Component cell) {
        List<String> texts = new ArrayList<>();
        if (cell instanceof JLabel label && label.getText() != null) {
            texts.add(label.getText());
        } else if (cell instanceof Container container) {
            for (Component child : container.getComponents()) {
                texts.addAll(texts(child));
            }
        }
        return texts;
    }

    private void checkHeads(JTable table) {
        JTableHeader header = table.getTableHeader();
        for (int column = 0;
                header != null && header.getParent() != null && column < table.getColumnCount();
                column++) {
            TableCellRenderer renderer = header.getDefaultRenderer();
            Object title = table.getColumnName(column);
            int wanted = renderer.getTableCellRendererComponent(table, title, false, false, -1, column)
                    .getPreferredSize()
                    .width;
            int width = table.getColumnModel().getColumn(column).getWidth();
            if (width + SLACK_PX < wanted) {
                faults.add(nameOf(table) + " cuts the head of column " + column + ": \"" + title + "\"");
            }
        }
    }

    /** Texts lie inside of what holds them, and not on one another. */
    private void checkChildren(Container container) {
        if (container instanceof JViewport || container instanceof JLayeredPane) {
            return;
        }
        List<Component> children = new ArrayList<>();
        for (Component child : container.getComponents()) {
            if (child.isVisible() && hasText(child)) {
                children.add(child);
            }
        }
        for (int i = 0; i < children.size(); i++) {
            Rectangle bounds = children.get(i).getBounds();
            if (bounds.width == 0 || bounds.height == 0 || !grown(container).contains(bounds)) {
                faults.add(nameOf(children.get(i)) + " at " + words(bounds) + " reaches out of " + nameOf(container)
                        + " of " + container.getWidth() + " x " + container.getHeight());
            }
            for (Component other : children.subList(i + 1, children.size())) {
                Rectangle both = bounds.intersection(other.getBounds());
                if (both.width > SLACK_PX && both.height > SLACK_PX) {
                    faults.add(nameOf(children.get(i)) + " lies on " + nameOf(other));
                }
            }
        }
    }

    private static Rectangle grown(Container container) {
        Rectangle room = new Rectangle(new Point(), container.getSize());
        room.grow(SLACK_PX, SLACK_PX);
        return room;
    }

    private static String words(Rectangle bounds) {
        return bounds.x + "," + bounds.y + " of " + bounds.width + " x " + bounds.height;
    }

    private static boolean hasText(Component component) {
        if (component instanceof JLabel label) {
            return label.getText() != null && !label.getText().isBlank();
        }
        if (component instanceof AbstractButton button) {
            return button.getText() != null && !button.getText().isBlank();
        }
        if (component instanceof JTextArea || component instanceof JTextField || component instanceof JComboBox) {
            return true;
        }
        if (component instanceof Container container) {
            for (Component child : container.getComponents()) {
                if (child.isVisible() && hasText(child)) {
                    return true;
                }
            }
        }
        return false;
    }

    private static String nameOf(Component component) {
        String name = component.getName();
        return name != null ? name : component.getClass().getSimpleName();
    }
}
