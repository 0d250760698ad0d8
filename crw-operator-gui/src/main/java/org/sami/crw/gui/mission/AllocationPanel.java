package org.sami.crw.gui.mission;

import java.awt.BorderLayout;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.Icon;
import javax.swing.JPanel;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.operator.AllocationSnapshot;
import org.sami.spn.value.TaskId;
import org.sami.ui.look.MarkIcon;
import org.sami.ui.table.RowColumn;
import org.sami.ui.table.RowTable;

/** Who has which tasks, in the order in which they are done, and which nobody has. */
public final class AllocationPanel extends JPanel {
    private final OperatorContext context;
    private final RowTable<Row> table;

    /** A task and whose it is; empty text where nobody has it. */
    private record Row(String boat, int place, TaskId task) {}

    /** The tasks of the session. */
    public AllocationPanel(OperatorContext context) {
        super(new BorderLayout());
        this.context = context;
        table = new RowTable<>(
                "allocation-table",
                "No task. Plans of tasks divide them here among the boats, each with its own queue.",
                Row::task,
                List.of(
                        RowColumn.<Row>words("Boat", 96, row -> row.boat().isEmpty() ? "nobody" : row.boat())
                                .withIcon(this::mark),
                        RowColumn.number("Turn", 56, row -> row.boat().isEmpty() ? "–" : row.place() + "."),
                        RowColumn.words(
                                "Task",
                                0,
                                row -> row.task().name() + " (mission "
                                        + row.task().mission() + ")")));
        add(table);
        context.models().allocation().addListener(this::show);
        show(context.models().allocation().snapshot());
    }

    private Optional<Icon> mark(Row row) {
        return row.boat().isEmpty()
                ? Optional.empty()
                : Optional.of(new MarkIcon(context.marks().of(row.boat())));
    }

    private void show(AllocationSnapshot now) {
        List<Row> rows = new ArrayList<>();
        now.queues().forEach((boat, tasks) -> {
            for (int i = 0; i < tasks.size(); i++) {
                rows.add(new Row(boat, i + 1, tasks.get(i)));
            }
        });
        now.unallocated().forEach(task -> rows.add(new Row("", 0, task)));
        table.show(rows);
    }
}
