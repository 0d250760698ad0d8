package org.sami.crw.gui.decision;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.util.List;
import java.util.Set;
import java.util.function.LongConsumer;
import javax.swing.BorderFactory;
import javax.swing.JPanel;
import javax.swing.ListSelectionModel;
import org.sami.crw.operator.decision.PendingDecision;
import org.sami.palette.SemanticColor;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Priority;
import org.sami.ui.look.LookColors;
import org.sami.ui.table.RowColumn;
import org.sami.ui.table.RowTable;

/**
 * All decisions that wait, a line each, the most urgent first; the shown one is selected. Selecting one shows it and answers nothing. Where there is
 * no room for all of them the list scrolls by itself. On the event thread.
 */
final class WaitingList extends JPanel {
    private static final int LEAST_ROWS = 2;

    private final RowTable<WaitingRow> table = new RowTable<>(
            "decisions-queue",
            "No decision waits.",
            WaitingRow::decision,
            List.of(
                    RowColumn.words("Waits for you", 0, WaitingRow::question).colored(WaitingList::color),
                    RowColumn.words("Mission", 190, WaitingRow::mission),
                    RowColumn.number("Since", 64, WaitingRow::age),
                    RowColumn.<WaitingRow>number("Left", 72, WaitingRow::left)
                            .colored(row -> row.left().equals("–") ? SemanticColor.MUTED : SemanticColor.WARNING)));
    private long inFull = Ids.NONE;
    private int rows;
    private int room = Integer.MAX_VALUE;

    /** @param selected is given the id of a decision that is to be shown */
    WaitingList(LongConsumer selected) {
        super(new BorderLayout());
        setName("decisions-waiting");
        setVisible(false);
        LookColors.border(this, () -> BorderFactory.createMatteBorder(1, 0, 0, 0, SemanticColor.BORDER.get()));
        table.showOneLine();
        table.table().setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        table.table().getAccessibleContext().setAccessibleName("Decisions that wait");
        table.addSelectionListener(() -> table.selected().ifPresent(row -> selected.accept(row.decision())));
        add(table);
    }

    private static SemanticColor color(WaitingRow row) {
        return row.priority() == Priority.CRITICAL
                ? SemanticColor.CRITICAL
                : row.priority() == Priority.HIGH ? SemanticColor.WARNING : SemanticColor.TEXT;
    }

    /**
     * Shows these as they are now.
     *
     * @param shown the id of the decision that is shown in full
     */
    void show(List<PendingDecision> queue, long shown, long nowMillis) {
        table.show(queue.stream().map(one -> WaitingRow.of(one, nowMillis)).toList());
        if (shown != inFull) {
            inFull = shown;
            table.offer(Set.of(shown));
        } else {
            table.selectKeys(Set.of(shown));
        }
    }

    /** Is so high from now on that this many rows are seen, as far as there is room; a single one is shown in full already. */
    void showRows(int count) {
        if (rows != count) {
            rows = count;
            setVisible(count > 1);
            revalidate();
        }
    }

    /**
     * Takes no more than this height, in pixels, but for two rows.
     *
     * @param low whether the titles of its columns are left out
     */
    void fit(int most, boolean low) {
        table.showTitles(!low);
        if (room != most) {
            room = most;
            invalidate();
        }
    }

    @Override
    public Dimension getPreferredSize() {
        int head = getInsets().top + table.heightOf(0);
        int fitting = Math.max(LEAST_ROWS, (room - head) / (table.heightOf(1) - table.heightOf(0)));
        return new Dimension(0, getInsets().top + table.heightOf(Math.min(rows, fitting)));
    }

    @Override
    public Dimension getMinimumSize() {
        return getPreferredSize();
    }
}
