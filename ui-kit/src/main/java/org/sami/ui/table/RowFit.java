package org.sami.ui.table;

import java.awt.Dimension;
import java.awt.Point;
import java.awt.Rectangle;
import java.util.Arrays;
import java.util.List;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.table.TableColumn;

/** How high the rows of a {@link RowTable} are, and which of them are seen: some at least, whole ones, one that is offered. On the event thread. */
final class RowFit<R> {
    private static final int MOST_LINES = 4; // the rest is in the tooltip
    private static final int LEAST_SEEN = 2;

    private final JScrollPane pane;
    private final JTable table;
    private final List<RowColumn<R>> columns;
    private final Supplier<List<R>> rows;
    private int mostPossible = MOST_LINES;
    private int leastSeen = LEAST_SEEN;
    private boolean whole;
    private boolean offered;
    private int mostLines = MOST_LINES;

    /**
     * The rows of a table.
     *
     * @param pane in which the table is scrolled
     * @param rows those that are shown
     */
    RowFit(JScrollPane pane, JTable table, List<RowColumn<R>> columns, Supplier<List<R>> rows) {
        this.pane = pane;
        this.table = table;
        this.columns = columns;
        this.rows = rows;
    }

    /** Has rows of one height, of which whole ones are seen, so many at least. */
    void showWhole(int least) {
        leastSeen = least;
        whole = true;
        pane.revalidate();
    }

    /** Has rows of one line each; the tooltip has what is cut. */
    void showOneLine() {
        mostPossible = 1;
    }

    /** Keeps the first selected row in view from now on. */
    void offer() {
        offered = true;
        if (whole) {
            pane.revalidate(); // whole rows are seen by its layout only
        } else {
            reveal();
        }
    }

    /** The user looks elsewhere. */
    void leave() {
        offered = false;
    }

    /** How many lines a cell has at most. */
    int mostLines() {
        return mostLines;
    }

    /**
     * Makes each row as high as its words need at the width of their columns, or all as high as the highest; in a low table only so high that
     * some are seen.
     */
    void fit() {
        if (table.getWidth() == 0 || room() == 0) {
            return; // its layout will do it
        }
        int[] lines =
                IntStream.range(0, rows.get().size()).map(this::linesNeeded).toArray();
        int most = IntStream.of(lines).max().orElse(1);
        if (whole) {
            Arrays.fill(lines, most);
        }
        mostLines = most;
        while (mostLines > 1 && !areEnoughSeen(lines)) {
            mostLines--;
        }
        for (int row = 0; row < lines.length; row++) {
            int height = height(lines[row]);
            if (table.getRowHeight(row) != height) {
                table.setRowHeight(row, height);
            }
        }
    }

    private int height(int linesNeeded) {
        return RowCell.height(table, Math.min(mostLines, linesNeeded));
    }

    /** Whether the required number of neighbouring rows is visible together at every position of the view. */
    private boolean areEnoughSeen(int[] lines) {
        int together = Math.min(leastSeen, lines.length);
        int heights = 0;
        for (int row = 0; row < lines.length; row++) {
            heights += height(lines[row]) - (row < together ? 0 : height(lines[row - together]));
            if (heights > room()) {
                return false;
            }
        }
        return true;
    }

    private int linesNeeded(int row) {
        int lines = 1;
        for (int at = 0; at < table.getColumnCount(); at++) {
            TableColumn column = table.getColumnModel().getColumn(at);
            RowColumn<R> shown = columns.get(column.getModelIndex());
            lines = Math.max(
                    lines,
                    RowCell.lines(table, shown, rows.get().get(row), column.getWidth(), mostPossible)
                            .size());
        }
        return lines;
    }

    /** The height in which rows are seen, with what is left below them. */
    private int room() {
        return pane.getViewport().getHeight() == 0
                ? 0
                : pane.getHeight() - pane.getViewport().getY() - pane.getInsets().bottom;
    }

    /** The table has its size. */
    void tableLaidOut() {
        fit();
        if (!whole) {
            reveal();
        }
    }

    /**
     * The pane has its size. What a whole row does not fill is left below the rows.
     *
     * @param before where the view on the table was
     */
    void paneLaidOut(Point before) {
        if (!whole) {
            fit(); // a table of another height alone is not laid out itself
            reveal();
        } else if (table.getRowCount() > 0) {
            Dimension seen = pane.getViewport().getSize();
            table.setSize(seen.width, Math.max(seen.height, table.getHeight()));
            table.doLayout(); // rows are as high as the width of columns lets them be
            int height = table.getRowHeight(0);
            if (height < seen.height) {
                pane.getViewport().setSize(seen.width, seen.height - seen.height % height);
            }
            pane.getViewport().setViewPosition(before); // in the higher view the last rows were moved down
            reveal();
        }
    }

    /** Moves the view by hand: the table's own way lays it out, and this is done while it is laid out. */
    private void reveal() {
        int row = table.getSelectedRow();
        if (offered && row >= 0) {
            Rectangle cell = table.getCellRect(row, 0, true);
            Rectangle seen = pane.getViewport().getViewRect();
            int y = Math.min(cell.y, Math.max(seen.y, cell.y + cell.height - seen.height));
            if (y != seen.y) {
                pane.getViewport().setViewPosition(new Point(seen.x, y));
            }
        }
    }
}
