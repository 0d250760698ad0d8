package org.sami.ui.table;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.SwingConstants;
import javax.swing.table.AbstractTableModel;
import javax.swing.table.DefaultTableCellRenderer;
import javax.swing.table.TableCellRenderer;
import javax.swing.table.TableColumn;
import org.sami.ui.look.Look;
import org.sami.ui.look.SemanticColor;
import org.sami.ui.look.Spacing;

/**
 * A table of immutable rows. When they are replaced, the selection stays with what was selected. An empty table says what would appear in
 * it. On the event thread.
 *
 * @param <R> type of the rows
 */
public final class RowTable<R> extends JScrollPane {
    private static final int ROW_HEIGHT = 30;

    private final Function<R, Object> key;
    private final List<RowColumn<R>> columns;
    private final Rows model = new Rows();
    private final JTable table;
    private final List<Runnable> selectionListeners = new ArrayList<>();
    private List<R> rows = List.of();
    private boolean replacing;

    /**
     * An empty table.
     *
     * @param name of the component
     * @param key what a row is about: equal for the same thing at two moments
     * @param nothingYet what an empty table says
     */
    public RowTable(String name, String nothingYet, Function<R, Object> key, List<RowColumn<R>> columns) {
        this.key = key;
        this.columns = List.copyOf(columns);
        table = new View(nothingYet);
        table.setName(name);
        table.setFillsViewportHeight(true);
        table.setShowVerticalLines(false);
        table.setDefaultRenderer(Object.class, new Cell());
        table.getTableHeader().setReorderingAllowed(false);
        table.getTableHeader().setDefaultRenderer(header(table.getTableHeader().getDefaultRenderer()));
        table.putClientProperty("terminateEditOnFocusLost", true);
        table.getSelectionModel().addListSelectionListener(e -> {
            if (!replacing && !e.getValueIsAdjusting()) {
                selectionListeners.forEach(Runnable::run);
            }
        });
        setViewportView(table);
        setBorder(BorderFactory.createEmptyBorder());
        scale();
    }

    private TableCellRenderer header(TableCellRenderer standard) {
        return (view, value, selected, focused, row, column) -> {
            Component cell = standard.getTableCellRendererComponent(view, value, selected, focused, row, column);
            if (cell instanceof JLabel label) {
                boolean right = columns.get(column).right();
                label.setHorizontalAlignment(right ? SwingConstants.RIGHT : SwingConstants.LEFT);
                label.setBorder(BorderFactory.createEmptyBorder(
                        Look.px(Spacing.TIGHT),
                        Look.px(Spacing.NORMAL),
                        Look.px(Spacing.TIGHT),
                        Look.px(Spacing.NORMAL)));
            }
            return cell;
        };
    }

    /** The table itself, for keys and names. */
    public JTable table() {
        return table;
    }

    /** Replaces the rows. */
    public void show(List<R> next) {
        if (next.equals(rows)) {
            return;
        }
        Set<Object> selected = new HashSet<>();
        allSelected().forEach(row -> selected.add(key.apply(row)));
        boolean same = next.size() == rows.size();
        replacing = true;
        rows = List.copyOf(next);
        if (same) {
            table.repaint();
            model.fireTableRowsUpdated(0, Math.max(0, rows.size() - 1));
        } else {
            model.fireTableDataChanged();
        }
        select(selected);
        replacing = false;
    }

    private void select(Set<Object> keys) {
        table.clearSelection();
        for (int i = 0; i < rows.size(); i++) {
            if (keys.contains(key.apply(rows.get(i)))) {
                table.addRowSelectionInterval(i, i);
            }
        }
    }

    /** Selects what these keys are about, as somebody did it elsewhere; listeners are not told. */
    public void selectKeys(Set<Object> keys) {
        replacing = true;
        select(keys);
        replacing = false;
    }

    /** The selected row, if one is; of several the first. */
    public Optional<R> selected() {
        return allSelected().stream().findFirst();
    }

    /** All selected rows, in order. */
    public List<R> allSelected() {
        List<R> all = new ArrayList<>();
        for (int index : table.getSelectedRows()) {
            if (index < rows.size()) {
                all.add(rows.get(index));
            }
        }
        return all;
    }

    /** Is told when the user selects something else. */
    public void addSelectionListener(Runnable listener) {
        selectionListeners.add(listener);
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (table != null) {
            setBorder(BorderFactory.createEmptyBorder());
            scale();
        }
    }

    private void scale() {
        table.setRowHeight(Look.px(ROW_HEIGHT));
        for (int i = 0; i < columns.size(); i++) {
            TableColumn column = table.getColumnModel().getColumn(i);
            int width = columns.get(i).width();
            if (width > 0) {
                column.setPreferredWidth(Look.px(width));
                column.setMinWidth(Look.px(width));
                column.setMaxWidth(Look.px(width * 2));
            }
        }
    }

    private final class Rows extends AbstractTableModel {
        @Override
        public int getRowCount() {
            return rows == null ? 0 : rows.size();
        }

        @Override
        public int getColumnCount() {
            return columns.size();
        }

        @Override
        public String getColumnName(int column) {
            return columns.get(column).title();
        }

        @Override
        public Object getValueAt(int row, int column) {
            return columns.get(column).text().apply(rows.get(row));
        }
    }

    private final class View extends JTable {
        private final JLabel nothing;

        View(String nothingYet) {
            super(model);
            nothing = new JLabel(
                    "<html><div style='text-align:center'>" + nothingYet + "</div></html>", SwingConstants.CENTER);
            setPreferredScrollableViewportSize(new Dimension(0, 0));
        }

        @Override
        protected void paintComponent(Graphics g) {
            super.paintComponent(g);
            if (getRowCount() == 0) {
                int inset = Look.px(Spacing.WIDE);
                nothing.setForeground(SemanticColor.MUTED.get());
                nothing.setFont(getFont());
                nothing.setSize(Math.max(0, getWidth() - 2 * inset), getHeight());
                Graphics own = g.create();
                own.translate(inset, 0);
                nothing.paint(own);
                own.dispose();
            }
        }

        @Override
        public String getToolTipText(MouseEvent event) {
            int row = rowAtPoint(event.getPoint());
            int column = columnAtPoint(event.getPoint());
            return row < 0 || column < 0 ? null : String.valueOf(getValueAt(row, column));
        }
    }

    private final class Cell extends DefaultTableCellRenderer {
        @Override
        public Component getTableCellRendererComponent(
                JTable view, Object value, boolean selected, boolean focused, int row, int column) {
            super.getTableCellRendererComponent(view, value, selected, false, row, column);
            RowColumn<R> how = columns.get(column);
            R what = rows.get(row);
            setHorizontalAlignment(how.right() ? SwingConstants.RIGHT : SwingConstants.LEFT);
            setForeground(
                    selected
                            ? SemanticColor.ON_SELECTION.get()
                            : how.color().apply(what).get());
            setBackground((selected ? SemanticColor.SELECTION : SemanticColor.SURFACE).get());
            setIcon(how.icon().apply(what).orElse(null));
            setIconTextGap(Look.px(Spacing.NORMAL));
            setBorder(BorderFactory.createEmptyBorder(0, Look.px(Spacing.NORMAL), 0, Look.px(Spacing.NORMAL)));
            return this;
        }
    }
}
