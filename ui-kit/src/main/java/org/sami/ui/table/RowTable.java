package org.sami.ui.table;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.SwingConstants;
import javax.swing.table.AbstractTableModel;
import javax.swing.table.TableCellRenderer;
import javax.swing.table.TableColumn;
import org.sami.ui.look.Look;
import org.sami.ui.look.SemanticColor;
import org.sami.ui.look.Spacing;
import org.sami.ui.value.WrappedText;

/**
 * A table of immutable rows. When they are replaced, the selection stays with what was selected. Words that do not fit their column go on
 * in further lines; a narrow table leaves spare columns out. An empty table says what would appear in it. On the event thread.
 *
 * @param <R> type of the rows
 */
public final class RowTable<R> extends JScrollPane {
    private static final int LEAST_WORDS = 84;
    private static final int LEAST_REST = 170; // logical pixels of a column that has what is left
    private static final int MOST_LINES = 4; // the rest is in the tooltip

    private final Function<R, Object> key;
    private final List<RowColumn<R>> columns;
    private final Rows model = new Rows();
    private final JTable table;
    private final List<TableColumn> all;
    private final List<Runnable> selectionListeners = new ArrayList<>();
    private List<R> rows = List.of();
    private boolean replacing;
    private boolean revealing;
    private int leastWhole;
    private int mostLines = MOST_LINES;

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
        all = Collections.list(table.getColumnModel().getColumns());
        table.setFillsViewportHeight(true);
        table.setShowVerticalLines(false);
        table.setDefaultRenderer(Object.class, new Cell());
        table.getTableHeader().setReorderingAllowed(false);
        table.getTableHeader().setDefaultRenderer(header(table.getTableHeader().getDefaultRenderer()));
        table.putClientProperty("terminateEditOnFocusLost", true);
        table.getSelectionModel().addListSelectionListener(e -> {
            if (!replacing && !e.getValueIsAdjusting()) {
                revealing = false;
                selectionListeners.forEach(Runnable::run);
            }
        });
        setViewportView(table);
        getViewport().addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent e) {
                if (leastWhole == 0) { // else its own layout has done it
                    reveal();
                }
            }
        });
        addMouseWheelListener(e -> revealing = false);
        getVerticalScrollBar().addMouseListener(new MouseAdapter() {
            @Override
            public void mousePressed(MouseEvent e) {
                revealing = false;
            }
        });
        setBorder(BorderFactory.createEmptyBorder());
        scale();
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
        leastWhole = least;
        revalidate();
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
        fitRows();
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

    /**
     * Selects what these keys are about, and keeps the first of it in view until the user selects something else or scrolls: also while the table is
     * given its size. Listeners are not told.
     */
    public void offer(Set<Object> keys) {
        selectKeys(keys);
        revealing = true;
        if (leastWhole == 0) {
            reveal();
        } else {
            revalidate(); // whole rows are seen by its layout only
        }
    }

    /** Moves the view by hand: the table's own way lays it out, and this is done while it is laid out. */
    private void reveal() {
        int row = table.getSelectedRow();
        if (revealing && row >= 0) {
            Rectangle cell = table.getCellRect(row, 0, true);
            Rectangle seen = getViewport().getViewRect();
            int y = Math.min(cell.y, Math.max(seen.y, cell.y + cell.height - seen.height));
            if (y != seen.y) {
                getViewport().setViewPosition(new Point(seen.x, y));
            }
        }
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
        table.setRowHeight(RowCell.leastHeight());
        for (int i = 0; i < columns.size(); i++) {
            TableColumn column = all.get(i);
            int width = columns.get(i).width();
            if (width > 0) {
                column.setPreferredWidth(Look.px(width));
                column.setMinWidth(Look.px(width));
                column.setMaxWidth(Look.px(width * 2));
            }
        }
    }

    /** What a whole row does not fill is left below the rows. */
    @Override
    public void doLayout() {
        Point before = getViewport().getViewPosition();
        super.doLayout();
        if (leastWhole > 0 && !rows.isEmpty()) {
            Dimension seen = getViewport().getSize();
            table.setSize(seen.width, Math.max(seen.height, table.getHeight()));
            table.doLayout(); // rows are as high as the width of columns lets them be
            int height = table.getRowHeight(0);
            if (height < seen.height) {
                getViewport().setSize(seen.width, seen.height - seen.height % height);
            }
            getViewport().setViewPosition(before); // in the higher view the last rows were moved down
            reveal();
        }
    }

    /** The height in which rows are seen, with what is left below them. */
    private int room() {
        return getViewport().getHeight() == 0 ? 0 : getHeight() - getViewport().getY() - getInsets().bottom;
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
            hint = new WrappedText(nothingYet);
            hint.setName(name + "-empty");
            hint.setColor(SemanticColor.MUTED);
            add(hint);
            setPreferredScrollableViewportSize(new Dimension(0, 0));
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
            fitColumns(getWidth());
            super.doLayout();
            fitRows();
            if (leastWhole == 0) {
                reveal();
            }
            int inset = Look.px(Spacing.WIDE);
            int width = Math.max(1, getWidth() - 2 * inset);
            hint.setVisible(getRowCount() == 0);
            hint.setSize(width, Short.MAX_VALUE);
            int height = hint.getPreferredSize().height;
            hint.setBounds(inset, Math.max(Look.px(Spacing.NORMAL), (getHeight() - height) / 2), width, height);
        }

        @Override
        public String getToolTipText(MouseEvent event) {
            int row = rowAtPoint(event.getPoint());
            int column = columnAtPoint(event.getPoint());
            return row < 0 || column < 0 ? null : TooltipLines.of(getValueAt(row, column) + leftOut(row));
        }
    }

    /** What columns say of a row that are left out, each in a sentence of its own. */
    private String leftOut(int row) {
        List<TableColumn> shown = Collections.list(table.getColumnModel().getColumns());
        return all.stream()
                .filter(column -> !shown.contains(column))
                .map(column -> columns.get(column.getModelIndex()))
                .map(column -> ". " + column.title() + ": " + column.text().apply(rows.get(row)))
                .collect(Collectors.joining());
    }

    /** Leaves out as many spare columns as others need room, the last one first. */
    private void fitColumns(int width) {
        int needed = columns.stream().mapToInt(RowTable::leastWidth).sum();
        Set<Integer> out = new HashSet<>();
        for (int i = columns.size() - 1; i >= 0 && needed > width && width > 0; i--) {
            if (columns.get(i).spare()) {
                out.add(i);
                needed -= leastWidth(columns.get(i));
            }
        }
        shrinkWords(needed - width);
        for (int i = 0; i < columns.size(); i++) {
            if (columns.get(i).width() == 0) {
                all.get(i).setPreferredWidth(Math.max(Look.px(LEAST_REST), width - needed + Look.px(LEAST_REST)));
            }
        }
        for (int i = 0, at = 0; i < all.size(); i++) {
            boolean there =
                    at < table.getColumnCount() && table.getColumnModel().getColumn(at) == all.get(i);
            if (there && out.contains(i)) {
                table.removeColumn(all.get(i));
            } else if (!there && !out.contains(i)) {
                table.addColumn(all.get(i));
                table.moveColumn(table.getColumnCount() - 1, at);
            }
            at += out.contains(i) ? 0 : 1;
        }
    }

    private static int leastWidth(RowColumn<?> column) {
        return Look.px(column.width() > 0 ? column.width() : LEAST_REST);
    }

    /** Words go on in further lines: where even so not all has room, columns of words become narrower. */
    private void shrinkWords(int missing) {
        int words = columns.stream()
                .filter(column -> !column.right())
                .mapToInt(column -> Look.px(column.width()))
                .sum();
        for (int i = 0; i < columns.size(); i++) {
            int width = Look.px(columns.get(i).width());
            if (!columns.get(i).right() && width > 0) {
                int fair = missing <= 0 ? width : width - missing * width / words;
                int given = Math.max(Math.min(width, Look.px(LEAST_WORDS)), fair);
                all.get(i).setMinWidth(given);
                all.get(i).setPreferredWidth(given);
            }
        }
    }

    /** Makes each row as high as its words need at the width of their columns, or all as high as the highest. */
    private void fitRows() {
        if (table.getWidth() == 0) {
            return; // its layout will do it
        }
        mostLines = MOST_LINES;
        int highest = leastWhole > 0 ? highest() : 0;
        while (leastWhole * highest > room() && mostLines > 1) {
            mostLines--;
            highest = highest();
        }
        for (int row = 0; row < rows.size(); row++) {
            int height = leastWhole > 0 ? highest : height(row);
            if (table.getRowHeight(row) != height) {
                table.setRowHeight(row, height);
            }
        }
    }

    private int highest() {
        return IntStream.range(0, rows.size()).map(this::height).max().orElse(0);
    }

    private int height(int row) {
        int height = RowCell.leastHeight();
        for (int at = 0; at < table.getColumnCount(); at++) {
            TableColumn column = table.getColumnModel().getColumn(at);
            RowColumn<R> shown = columns.get(column.getModelIndex());
            height = Math.max(height, RowCell.height(table, shown, rows.get(row), column.getWidth(), mostLines));
        }
        return height;
    }

    private final class Cell implements TableCellRenderer {
        private final RowCell<R> cell = new RowCell<>();

        @Override
        public Component getTableCellRendererComponent(
                JTable view, Object value, boolean selected, boolean focused, int row, int at) {
            TableColumn column = view.getColumnModel().getColumn(at);
            RowColumn<R> shown = columns.get(column.getModelIndex());
            cell.show(view, shown, rows.get(row), selected, column.getWidth(), mostLines);
            return cell;
        }
    }
}
