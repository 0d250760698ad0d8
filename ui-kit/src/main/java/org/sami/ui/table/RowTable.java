package org.sami.ui.table;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
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
import javax.swing.JViewport;
import javax.swing.SwingConstants;
import javax.swing.SwingUtilities;
import javax.swing.table.AbstractTableModel;
import javax.swing.table.TableCellRenderer;
import javax.swing.table.TableColumn;
import org.jspecify.annotations.Nullable;
import org.sami.palette.SemanticColor;
import org.sami.ui.look.FocusFrame;
import org.sami.ui.look.Look;
import org.sami.ui.look.Spacing;
import org.sami.ui.look.TabKey;
import org.sami.ui.value.WrappedText;

/**
 * A table of immutable rows. When they are replaced, the selection stays with what was selected. Words that do not fit their column go on
 * in further lines, in a low table in so few that two rows are seen; a narrow table leaves spare columns out. An empty table says what would
 * appear in it. On the event thread.
 *
 * @param <R> type of the rows
 */
public final class RowTable<R> extends JScrollPane {
    private final Function<R, Object> key;
    private final List<RowColumn<R>> columns;
    private final Rows model = new Rows();
    private final JTable table;
    private final ColumnFit<R> columnFit;
    private final RowFit<R> rowFit;
    private final List<Runnable> selectionListeners = new ArrayList<>();
    private List<R> rows = List.of();
    private boolean replacing;
    private boolean all;

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
        table = new View(name, nothingYet);
        table.setAutoCreateColumnsFromModel(false);
        columnFit = new ColumnFit<>(table, this.columns);
        rowFit = new RowFit<>(this, table, this.columns, () -> rows);
        table.setFillsViewportHeight(true);
        table.setShowVerticalLines(false);
        table.setDefaultRenderer(Object.class, new Cell());
        table.getTableHeader().setReorderingAllowed(false);
        table.getTableHeader().setDefaultRenderer(header(table.getTableHeader().getDefaultRenderer()));
        table.putClientProperty("terminateEditOnFocusLost", true);
        table.getSelectionModel().addListSelectionListener(e -> {
            if (!replacing && !e.getValueIsAdjusting()) {
                rowFit.leave();
                selectionListeners.forEach(Runnable::run);
            }
        });
        FocusFrame.watch(table);
        getViewport().addChangeListener(e -> {
            if (table.isFocusOwner()) {
                table.repaint(); // the line goes with what is seen
            }
        });
        setViewportView(table);
        addMouseWheelListener(this::wheelTurned);
        getVerticalScrollBar().addMouseListener(new MouseAdapter() {
            @Override
            public void mousePressed(MouseEvent e) {
                rowFit.leave();
            }
        });
        setBorder(BorderFactory.createEmptyBorder());
        scale();
        setColumnHeader(new JViewport() {
            @Override
            public Dimension getPreferredSize() {
                return table.getTableHeader().isVisible() ? super.getPreferredSize() : new Dimension(0, 0);
            }
        });
    }

    private TableCellRenderer header(TableCellRenderer standard) {
        return (view, value, selected, focused, row, column) -> {
            Component cell = standard.getTableCellRendererComponent(view, value, selected, focused, row, column);
            if (cell instanceof JLabel label) {
                boolean right =
                        columns.get(view.convertColumnIndexToModel(column)).right();
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

    /**
     * Has rows of one height, of which whole ones are seen.
     *
     * @param least so many at least: in a low table words go on in fewer lines, which end in dots
     */
    public void showWholeRows(int least) {
        rowFit.showWhole(least);
    }

    /** Has rows of one line each: what has no room ends in dots, and is in the tooltip. */
    public void showOneLine() {
        rowFit.showOneLine();
    }

    /** Is as high as all rows, and leaves scrolling to the pane in which it lies: two bars side by side are one too many. */
    public void showAllRows(boolean all) {
        this.all = all;
        revalidate();
    }

    @Override
    public Dimension getPreferredSize() {
        return all ? whole() : super.getPreferredSize();
    }

    @Override
    public Dimension getMinimumSize() {
        return all ? whole() : super.getMinimumSize();
    }

    private Dimension whole() {
        int head = table.getTableHeader().getPreferredSize().height;
        return new Dimension(0, head + table.getPreferredSize().height);
    }

    private void wheelTurned(MouseWheelEvent turned) {
        rowFit.leave();
        if (all && getParent() != null) {
            getParent().dispatchEvent(SwingUtilities.convertMouseEvent(this, turned, getParent()));
        }
    }

    /** Whether the titles of the columns are seen; where there is little room, rows matter more. */
    public void showTitles(boolean shown) {
        if (table.getTableHeader().isVisible() != shown) {
            table.getTableHeader().setVisible(shown);
            revalidate();
        }
    }

    /** How high it is with so many rows of one line, in pixels. */
    public int heightOf(int rows) {
        int titles = table.getTableHeader().isVisible() ? table.getTableHeader().getPreferredSize().height : 0;
        return titles + rows * table.getRowHeight();
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
        rowFit.fit();
        if (all && !same) {
            revalidate();
        }
    }

    private void select(Set<Object> keys) {
        table.clearSelection();
        for (int i = 0; i < rows.size(); i++) {
            if (keys.contains(key.apply(rows.get(i)))) {
                table.addRowSelectionInterval(i, i);
            }
        }
    }

    /** Selects the rows of these keys, as the user did elsewhere; listeners are not called. */
    public void selectKeys(Set<Object> keys) {
        replacing = true;
        select(keys);
        replacing = false;
    }

    /**
     * Selects what these keys are about, and keeps the first of it in view until the user selects something else or scrolls: also while the table is
     * given its size. Listeners are not called.
     */
    public void offer(Set<Object> keys) {
        selectKeys(keys);
        rowFit.offer();
    }

    /** The selected row, if one is; of several the first. */
    public Optional<R> selected() {
        return allSelected().stream().findFirst();
    }

    /** Whether the middle of the selected row is in sight: on the screen, and not scrolled away. */
    public boolean isSelectionSeen() {
        int row = table.getSelectedRow();
        if (row < 0 || !table.isShowing()) {
            return false;
        }
        Rectangle cell = table.getCellRect(row, 0, true);
        int middle = cell.y + cell.height / 2;
        Rectangle seen = table.getVisibleRect();
        return middle >= seen.y && middle < seen.y + seen.height;
    }

    /** Scrolls the selected row into sight. */
    public void scrollToSelection() {
        int row = table.getSelectedRow();
        if (row >= 0) {
            table.scrollRectToVisible(table.getCellRect(row, 0, true));
        }
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

    /** Calls a listener when the user selects something else. */
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
        table.setRowHeight(RowCell.leastHeight());
        columnFit.scale();
    }

    @Override
    public void doLayout() {
        Point before = getViewport().getViewPosition();
        super.doLayout();
        rowFit.paneLaidOut(before);
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
        private final WrappedText hint;

        View(String name, String nothingYet) {
            super(model);
            setName(name);
            getAccessibleContext().setAccessibleName(words(name));
            TabKey.leaves(this);
            hint = new WrappedText(nothingYet);
            hint.setName(name + "-empty");
            hint.setColor(SemanticColor.MUTED);
            add(hint);
            setPreferredScrollableViewportSize(new Dimension(0, 0));
        }

        /** What a table is called for those who do not see it: {@code Boat queue} for {@code boat-queue}, {@code Plans} for {@code plans-table}. */
        private static String words(String name) {
            String words = name.replaceFirst("-table$", "").replace('-', ' ').strip();
            return words.isEmpty() ? "Table" : Character.toUpperCase(words.charAt(0)) + words.substring(1);
        }

        /** Where the keyboard's focus is, a line around what is seen of the table says so. */
        @Override
        protected void paintComponent(Graphics g) {
            super.paintComponent(g);
            FocusFrame.paint(g, this);
        }

        /** An empty table is as high as its hint, so that it scrolls in a low panel. */
        @Override
        public Dimension getPreferredSize() {
            Dimension size = super.getPreferredSize();
            return hint == null || getRowCount() > 0
                    ? size
                    : new Dimension(size.width, hint.getPreferredSize().height + 2 * Look.px(Spacing.NORMAL));
        }

        @Override
        public void doLayout() {
            columnFit.fit(getWidth());
            super.doLayout();
            rowFit.tableLaidOut();
            int inset = Look.px(Spacing.WIDE);
            int width = Math.max(1, getWidth() - 2 * inset);
            hint.setVisible(getRowCount() == 0);
            hint.setSize(width, Short.MAX_VALUE);
            int height = hint.getPreferredSize().height;
            hint.setBounds(inset, Math.max(Look.px(Spacing.NORMAL), (getHeight() - height) / 2), width, height);
        }

        @Override
        public @Nullable String getToolTipText(MouseEvent event) {
            int row = rowAtPoint(event.getPoint());
            int column = columnAtPoint(event.getPoint());
            return row < 0 || column < 0
                    ? null
                    : TooltipLines.of(getValueAt(row, column) + columnFit.leftOut(rows.get(row)));
        }
    }

    private final class Cell implements TableCellRenderer {
        private final RowCell<R> cell = new RowCell<>();

        @Override
        public Component getTableCellRendererComponent(
                JTable view, Object value, boolean selected, boolean focused, int row, int at) {
            TableColumn column = view.getColumnModel().getColumn(at);
            RowColumn<R> shown = columns.get(column.getModelIndex());
            cell.show(view, shown, rows.get(row), selected, column.getWidth(), rowFit.mostLines());
            return cell;
        }
    }
}
