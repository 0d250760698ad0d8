package org.sami.dreamm.tryout;

import java.awt.BorderLayout;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.List;
import javax.swing.JPanel;
import org.sami.palette.SemanticColor;
import org.sami.ui.table.RowColumn;
import org.sami.ui.table.RowTable;

/** The steps that were taken, and what each did; a double click goes back to behind one. */
final class StepsView extends JPanel {
    private final transient TryOut tryOut;
    private final RowTable<TryOutLine> table;

    StepsView(TryOut tryOut) {
        super(new BorderLayout());
        this.tryOut = tryOut;
        table = new RowTable<>(
                "try-steps",
                "No step was taken yet.",
                TryOutLine::number,
                List.of(
                        RowColumn.<TryOutLine>number("", 36, line -> String.valueOf(line.number()))
                                .colored(line -> SemanticColor.MUTED),
                        RowColumn.words("Done", 0, TryOutLine::done),
                        RowColumn.<TryOutLine>words("What came of it", 0, TryOutLine::came)
                                .colored(line -> SemanticColor.MUTED)));
        table.table().addMouseListener(new MouseAdapter() {
            @Override
            public void mouseClicked(MouseEvent e) {
                if (e.getClickCount() == 2) {
                    table.selected().ifPresent(line -> tryOut.back(tryOut.steps() - line.number()));
                }
            }
        });
        table.setToolTipText("A double click goes back to behind a step");
        add(table);
        tryOut.addListener(this::refresh);
        refresh();
    }

    private void refresh() {
        List<TryOutLine> lines = tryOut.lines();
        table.show(lines);
        if (!lines.isEmpty()) {
            table.table().scrollRectToVisible(table.table().getCellRect(lines.size() - 1, 0, true));
        }
    }
}
