package org.sami.crw.gui.notice;

import java.awt.BorderLayout;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JPanel;
import javax.swing.JTextField;
import net.miginfocom.swing.MigLayout;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.operator.OperatorLogEntry;
import org.sami.palette.SemanticColor;
import org.sami.session.api.RefusedException;
import org.sami.ui.look.WidthTrackingPanel;
import org.sami.ui.replay.SessionClock;
import org.sami.ui.table.RowColumn;
import org.sami.ui.table.RowTable;

/** What the operator did, the newest first, and a line to write notes in. It is kept with the session. */
public final class LogPanel extends JPanel {
    private final OperatorContext context;
    private final RowTable<OperatorLogEntry> table;
    private final JTextField note = new JTextField();

    /** The log of the session. */
    public LogPanel(OperatorContext context) {
        super(new BorderLayout());
        this.context = context;
        table = new RowTable<>(
                "log-table",
                "Nothing was done yet. What you do, and notes that you write below, are kept here with the session.",
                OperatorLogEntry::number,
                List.of(
                        RowColumn.number("At", 72, entry -> SessionClock.text(entry.atMillis())),
                        RowColumn.<OperatorLogEntry>words(
                                        "Kind",
                                        110,
                                        entry -> context.say(entry.kind()
                                                .name()
                                                .toLowerCase(Locale.ROOT)
                                                .replace('_', ' ')))
                                .colored(entry -> SemanticColor.MUTED),
                        RowColumn.words("What", 0, OperatorLogEntry::text)));
        note.setName("log-note");
        note.putClientProperty("JTextField.placeholderText", "Write a note; Enter keeps it");
        note.getAccessibleContext().setAccessibleName("Note for the log");
        note.addActionListener(e -> write());
        JButton keep = new JButton("Keep note");
        keep.setName("log-keep");
        keep.setToolTipText("Keep the note in the log (Enter)");
        keep.addActionListener(e -> write());
        context.whyNotAct().ifPresent(why -> {
            note.setEnabled(false);
            keep.setEnabled(false);
            keep.setToolTipText(why);
        });
        JPanel line = new JPanel(new MigLayout("insets 4 8 4 8", "[grow][]", "[]"));
        line.add(note, "growx, hmin 40, wmin 60");
        line.add(keep, "hmin 40");
        JPanel all = new JPanel(new MigLayout("insets 0, gap 0, fill, wrap 1", "[grow,fill]", "[grow,fill][]"));
        all.add(table, "hmin 80");
        all.add(line);
        add(WidthTrackingPanel.fromLeastHeight(all));
        context.models().log().addListener(this::show);
        show(context.models().log().snapshot());
    }

    private void show(List<OperatorLogEntry> entries) {
        List<OperatorLogEntry> newestFirst = new ArrayList<>(entries);
        Collections.reverse(newestFirst);
        table.show(newestFirst);
    }

    private void write() {
        String text = note.getText().strip();
        if (!text.isEmpty()) {
            context.session().addNote(text, Optional.empty()).exceptionally(fault -> {
                context.notices().refused(RefusedException.reason(fault));
                return null;
            });
            note.setText("");
        }
    }
}
