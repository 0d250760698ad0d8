package org.sami.ui.table;

import java.util.Collections;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import javax.swing.JTable;
import javax.swing.table.TableColumn;
import org.sami.ui.look.Look;

/** Which columns of a {@link RowTable} have room, and how wide they are. On the event thread. */
final class ColumnFit<R> {
    private static final int LEAST_WORDS = 84;
    private static final int LEAST_REST = 170; // logical pixels of a column that has what is left

    private final JTable table;
    private final List<RowColumn<R>> columns;
    private final List<TableColumn> all;
    /** Which columns are left out, the first of them first. */
    private final List<Integer> leaving;

    /** The columns of a table, which shows all of them by now. */
    ColumnFit(JTable table, List<RowColumn<R>> columns) {
        this.table = table;
        this.columns = columns;
        all = Collections.list(table.getColumnModel().getColumns());
        leaving = IntStream.range(0, columns.size())
                .boxed()
                .filter(i -> columns.get(i).spare())
                .sorted(Comparator.comparing((Integer i) -> columns.get(i).last())
                        .thenComparing(Comparator.reverseOrder()))
                .toList();
    }

    /** Takes the widths at the scale in force. */
    void scale() {
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

    /** Leaves out as many spare columns as others need room. */
    void fit(int width) {
        int needed = columns.stream().mapToInt(ColumnFit::leastWidth).sum();
        Set<Integer> out = new HashSet<>();
        for (int i : leaving) {
            if (needed > width && width > 0) {
                out.add(i);
                needed -= leastWidth(columns.get(i));
            }
        }
        shrinkWords(needed - width, out);
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

    /** Words go on in further lines: where even so not all has room, columns of words that are not left out become narrower. */
    private void shrinkWords(int missing, Set<Integer> out) {
        int words = 0;
        for (int i = 0; i < columns.size(); i++) {
            words += columns.get(i).right() || out.contains(i)
                    ? 0
                    : Look.px(columns.get(i).width());
        }
        for (int i = 0; i < columns.size(); i++) {
            int width = Look.px(columns.get(i).width());
            if (!columns.get(i).right() && !out.contains(i) && width > 0) {
                int fair = missing <= 0 ? width : width - missing * width / words;
                int given = Math.max(Math.min(width, Look.px(LEAST_WORDS)), fair);
                all.get(i).setMinWidth(given);
                all.get(i).setPreferredWidth(given);
            }
        }
    }

    /** What columns say of a row that are left out, each in a sentence of its own. */
    String leftOut(R row) {
        List<TableColumn> shown = Collections.list(table.getColumnModel().getColumns());
        return all.stream()
                .filter(column -> !shown.contains(column))
                .map(column -> columns.get(column.getModelIndex()))
                .map(column -> ". " + column.title() + ": " + column.text().apply(row))
                .collect(Collectors.joining());
    }
}
