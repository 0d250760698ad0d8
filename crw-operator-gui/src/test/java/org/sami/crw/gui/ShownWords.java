package org.sami.crw.gui;

import java.awt.Component;
import java.awt.Container;
import java.awt.Rectangle;
import java.awt.event.MouseEvent;
import java.util.LinkedHashSet;
import java.util.Optional;
import java.util.Set;
import javax.swing.AbstractButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JMenu;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import javax.swing.text.JTextComponent;
import org.sami.ui.map.MapView;
import org.sami.ui.map.PaintingWork;

/** All words of a component and what lies in it: texts, tooltips, menus, cells of tables and lists, tabs, what a screen reader says, and what is painted. On the event thread. */
final class ShownWords {
    private final Set<String> words = new LinkedHashSet<>();

    private ShownWords() {}

    static Set<String> of(Component component) {
        ShownWords all = new ShownWords();
        all.walk(component);
        if (component.getWidth() > 0 && component.getHeight() > 0) {
            PaintingWork.textsOf(component).forEach(all::add);
        }
        return all.words;
    }

    private void add(String text) {
        Optional.ofNullable(text).filter(said -> !said.isBlank()).ifPresent(words::add);
    }

    private void walk(Component component) {
        if (component instanceof JLabel label) {
            add(label.getText());
        } else if (component instanceof AbstractButton button) {
            add(button.getText());
        } else if (component instanceof JTextComponent text) {
            add(text.getText());
            add(String.valueOf(text.getClientProperty("JTextField.placeholderText")));
        } else if (component instanceof JTable table) {
            addCells(table);
        } else if (component instanceof JTabbedPane tabs) {
            for (int i = 0; i < tabs.getTabCount(); i++) {
                add(tabs.getTitleAt(i));
                add(tabs.getToolTipTextAt(i));
            }
        } else if (component instanceof JComboBox<?> box) {
            addItems(box);
        } else if (component instanceof JList<?> list) {
            addRows(list);
        } else if (component instanceof MapView map) {
            map.layers().all().forEach(layer -> add(layer.title()));
        }
        if (component instanceof JComponent one) {
            add(one.getToolTipText());
        }
        if (component.getAccessibleContext() != null) {
            add(component.getAccessibleContext().getAccessibleName());
            add(component.getAccessibleContext().getAccessibleDescription());
        }
        if (component instanceof JMenu menu) {
            walk(menu.getPopupMenu());
        }
        if (component instanceof Container container) {
            for (Component child : container.getComponents()) {
                walk(child);
            }
        }
    }

    private void addCells(JTable table) {
        for (int column = 0; column < table.getColumnCount(); column++) {
            add(table.getColumnName(column));
            for (int row = 0; row < table.getRowCount(); row++) {
                walk(table.prepareRenderer(table.getCellRenderer(row, column), row, column));
                add(table.getToolTipText(pointed(table, table.getCellRect(row, column, true))));
            }
        }
    }

    private <E> void addRows(JList<E> list) {
        for (int row = 0; row < list.getModel().getSize(); row++) {
            Component cell = list.getCellRenderer()
                    .getListCellRendererComponent(list, list.getModel().getElementAt(row), row, false, false);
            walk(cell);
            Rectangle place = list.getCellBounds(row, row);
            if (place != null && !place.isEmpty()) {
                cell.setSize(place.getSize());
                PaintingWork.textsOf(cell).forEach(this::add);
                add(list.getToolTipText(pointed(list, place)));
            }
        }
    }

    /** The pointer in the middle of a place. */
    private static MouseEvent pointed(Component at, Rectangle place) {
        return new MouseEvent(
                at, MouseEvent.MOUSE_MOVED, 0, 0, (int) place.getCenterX(), (int) place.getCenterY(), 0, false);
    }

    private <E> void addItems(JComboBox<E> box) {
        for (int i = 0; i < box.getItemCount(); i++) {
            walk(box.getRenderer().getListCellRendererComponent(new JList<>(), box.getItemAt(i), i, false, false));
        }
    }
}
