package org.sami.dreamm.help.word;

import java.awt.Component;
import java.awt.Container;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Insets;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import javax.swing.AbstractButton;
import javax.swing.CellRendererPane;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import javax.swing.JToggleButton;
import javax.swing.JTree;
import javax.swing.SwingUtilities;
import javax.swing.table.JTableHeader;
import javax.swing.text.BadLocationException;
import javax.swing.text.JTextComponent;
import javax.swing.tree.TreePath;

/** Finds the words that components show: at a point, and where the focus is. On the event thread. */
final class ShownWords {
    private ShownWords() {}

    // ---- At a point

    /** What a component shows at a point; empty where that is no text, or text that is typed. */
    static Optional<ShownText> at(Component component, Point at) {
        for (Component each = component; each != null; each = each.getParent()) {
            if (each instanceof TermSource worded) {
                Optional<ShownText> words = worded.wordsAt(component, at);
                if (words.isPresent()) {
                    return words;
                }
            }
        }
        return SwingUtilities.getAncestorOfClass(JComboBox.class, component) instanceof JComboBox<?> combo
                ? Optional.of(ShownText.all(chosen(combo), whole(component)))
                : plain(component, at);
    }

    private static Optional<ShownText> plain(Component component, Point at) {
        if (component instanceof JComboBox<?> combo) {
            return Optional.of(ShownText.all(chosen(combo), whole(component)));
        } else if (component instanceof JLabel label) {
            return label(label, at);
        } else if (component instanceof AbstractButton button) {
            return Optional.of(ShownText.all(words(button), whole(button)));
        } else if (component instanceof JTextComponent text) {
            return text.isEditable() ? Optional.empty() : text(text, at);
        } else if (component instanceof JTableHeader header) {
            int column = header.columnAtPoint(at);
            return column < 0
                    ? Optional.empty()
                    : Optional.of(ShownText.all(header.getTable().getColumnName(column), header.getHeaderRect(column)));
        } else if (component instanceof JTabbedPane tabs) {
            int tab = tabs.indexAtLocation(at.x, at.y);
            return tab < 0 ? Optional.empty() : Optional.of(ShownText.all(tabs.getTitleAt(tab), tabs.getBoundsAt(tab)));
        }
        return cell(component, at);
    }

    private static Optional<ShownText> cell(Component component, Point at) {
        if (component instanceof JList<?> list) {
            int row = list.locationToIndex(at);
            Rectangle box = row < 0 ? null : list.getCellBounds(row, row);
            return box == null || !box.contains(at) ? Optional.empty() : drawn(cell(list, row), box, at);
        } else if (component instanceof JTable table) {
            int row = table.rowAtPoint(at);
            int column = table.columnAtPoint(at);
            return row < 0 || column < 0
                    ? Optional.empty()
                    : drawn(
                            table.prepareRenderer(table.getCellRenderer(row, column), row, column),
                            table.getCellRect(row, column, false),
                            at);
        } else if (component instanceof JTree tree) {
            int row = tree.getRowForLocation(at.x, at.y);
            return row < 0 ? Optional.empty() : drawn(cell(tree, row), tree.getRowBounds(row), at);
        }
        return Optional.empty();
    }

    private static <T> Component cell(JList<T> list, int row) {
        return list.getCellRenderer()
                .getListCellRendererComponent(
                        list, list.getModel().getElementAt(row), row, list.isSelectedIndex(row), false);
    }

    private static Component cell(JTree tree, int row) {
        TreePath path = tree.getPathForRow(row);
        Object node = path.getLastPathComponent();
        return tree.getCellRenderer()
                .getTreeCellRendererComponent(
                        tree,
                        node,
                        tree.isRowSelected(row),
                        tree.isExpanded(row),
                        tree.getModel().isLeaf(node),
                        row,
                        false);
    }

    /** What a renderer draws in the box of a cell: the word at the point, else all of the cell. */
    private static Optional<ShownText> drawn(Component cell, Rectangle box, Point at) {
        CellRendererPane pane = new CellRendererPane();
        pane.add(cell);
        cell.setBounds(0, 0, box.width, box.height);
        cell.validate();
        Point inside = new Point(at.x - box.x, at.y - box.y);
        Component inner = SwingUtilities.getDeepestComponentAt(cell, inside.x, inside.y);
        Optional<ShownText> words =
                inner == null ? Optional.empty() : plain(inner, SwingUtilities.convertPoint(cell, inside, inner));
        pane.removeAll();
        return words.map(found -> new ShownText(found.text(), found.at(), box));
    }

    private static Optional<ShownText> label(JLabel label, Point at) {
        String text = label.getText();
        if (text == null || text.isBlank()) {
            return Optional.empty();
        }
        Font font = label.getFont();
        FontMetrics metrics = label.getFontMetrics(font);
        Insets insets = label.getInsets();
        Rectangle view = new Rectangle(
                insets.left,
                insets.top,
                label.getWidth() - insets.left - insets.right,
                label.getHeight() - insets.top - insets.bottom);
        Rectangle icon = new Rectangle();
        Rectangle letters = new Rectangle();
        String shown = SwingUtilities.layoutCompoundLabel(
                label,
                metrics,
                text,
                label.getIcon(),
                label.getVerticalAlignment(),
                label.getHorizontalAlignment(),
                label.getVerticalTextPosition(),
                label.getHorizontalTextPosition(),
                view,
                icon,
                letters,
                label.getIconTextGap());
        int index = indexAt(shown, metrics, at.x - letters.x);
        return index < 0 || !letters.contains(at)
                ? Optional.empty()
                : Optional.of(new ShownText(text, Math.min(index, text.length() - 1), letters));
    }

    private static int indexAt(String text, FontMetrics metrics, int x) {
        for (int i = 0; x >= 0 && i < text.length(); i++) {
            if (metrics.stringWidth(text.substring(0, i + 1)) > x) {
                return i;
            }
        }
        return -1;
    }

    private static Optional<ShownText> text(JTextComponent text, Point at) {
        int index = text.viewToModel2D(at);
        try {
            Rectangle2D letter = text.modelToView2D(index);
            boolean there = letter != null
                    && at.y >= letter.getMinY()
                    && at.y < letter.getMaxY()
                    && Math.abs(at.x - letter.getX()) < 2 * letter.getHeight();
            int character = there && at.x < letter.getX() ? index - 1 : index;
            return there && character >= 0
                    ? Optional.of(new ShownText(text.getText(), character, around(at, letter)))
                    : Optional.empty();
        } catch (BadLocationException gone) {
            return Optional.empty();
        }
    }

    private static Rectangle around(Point at, Rectangle2D letter) {
        int line = (int) letter.getHeight();
        return new Rectangle(at.x - line, (int) letter.getY(), 2 * line, line);
    }

    /** What a button says, or, where it has an icon alone, what its tooltip says it does. */
    private static String words(AbstractButton button) {
        String text = button.getText() == null || button.getText().isBlank() ? tip(button) : button.getText();
        return button instanceof JToggleButton ? text : withoutVerb(text);
    }

    /** A command begins with what to do: "Add a place" speaks of places, not of tokens that are added. */
    private static String withoutVerb(String command) {
        return command.replaceFirst("^\\p{L}+ ", "");
    }

    private static String tip(JComponent component) {
        return Optional.ofNullable(component.getToolTipText()).orElse("");
    }

    private static Rectangle whole(Component component) {
        return new Rectangle(0, 0, component.getWidth(), component.getHeight());
    }

    // ---- Where the focus is

    /** The words that explain a component: what is selected in it, what it says, its label and its tooltip. */
    static String of(Component component) {
        for (Component each = component; each != null; each = each.getParent()) {
            if (each instanceof TermSource worded && worded.words().isPresent()) {
                return worded.words().orElseThrow();
            }
        }
        List<String> words = new ArrayList<>();
        selected(component).ifPresent(words::add);
        if (component instanceof JComponent shown) {
            if (shown.getClientProperty("labeledBy") instanceof JLabel label && label.getText() != null) {
                words.add(label.getText());
            }
            words.add(Optional.ofNullable(shown.getAccessibleContext().getAccessibleName())
                    .orElse(""));
            words.add(tip(shown));
        }
        return String.join(" \n", words);
    }

    private static Optional<String> selected(Component component) {
        if (component instanceof JList<?> list) {
            return list.isSelectionEmpty() ? Optional.empty() : Optional.of(all(cell(list, list.getSelectedIndex())));
        } else if (component instanceof JTree tree) {
            return tree.isSelectionEmpty() ? Optional.empty() : Optional.of(all(cell(tree, tree.getMinSelectionRow())));
        } else if (component instanceof JTable table && table.getSelectedRow() >= 0) {
            List<String> columns = new ArrayList<>();
            for (int i = 0; i < table.getColumnCount(); i++) {
                int row = table.getSelectedRow();
                columns.add(all(table.prepareRenderer(table.getCellRenderer(row, i), row, i)));
            }
            return Optional.of(String.join(" \n", columns));
        }
        return component instanceof JComboBox<?> combo ? Optional.of(chosen(combo)) : Optional.of(all(component));
    }

    private static <T> String chosen(JComboBox<T> combo) {
        JList<T> unused = new JList<>();
        Object chosen = combo.getSelectedItem();
        for (int i = 0; chosen != null && i < combo.getItemCount(); i++) {
            if (chosen.equals(combo.getItemAt(i))) {
                return all(
                        combo.getRenderer().getListCellRendererComponent(unused, combo.getItemAt(i), i, false, false));
            }
        }
        return chosen == null ? "" : chosen.toString();
    }

    /** All texts of a component and of those in it. */
    private static String all(Component component) {
        if (component instanceof JLabel label) {
            return Optional.ofNullable(label.getText()).orElse("");
        } else if (component instanceof AbstractButton button) {
            return words(button);
        } else if (component instanceof JTextComponent text) {
            return text.isEditable() ? "" : text.getText();
        }
        return component instanceof Container container
                ? List.of(container.getComponents()).stream()
                        .map(ShownWords::all)
                        .filter(words -> !words.isBlank())
                        .collect(Collectors.joining(" \n"))
                : "";
    }
}
