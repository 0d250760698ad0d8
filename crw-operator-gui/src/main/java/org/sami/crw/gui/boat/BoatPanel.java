package org.sami.crw.gui.boat;

import java.awt.BorderLayout;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.operator.BoatCommands;
import org.sami.crw.operator.BoatSnapshot;
import org.sami.crw.proxy.CommandQueueSnapshot.Entry;
import org.sami.ui.command.CommandButton;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.MarkIcon;
import org.sami.ui.look.SemanticColor;
import org.sami.ui.table.RowColumn;
import org.sami.ui.table.RowTable;

/** The selected boat: why it moves or not, the command in force and those that wait, the upload, what can be done with it by hand. */
public final class BoatPanel extends JPanel {
    private final OperatorContext context;
    private final JLabel name = new JLabel();
    private final JLabel why = new JLabel();
    private final JLabel facts = new JLabel();
    private final RowTable<Row> queue;
    private final JPanel buttons = new JPanel(
            new MigLayout("insets 4 8 8 8, wrap 3, fillx", "[grow, fill, sg][grow, fill, sg][grow, fill, sg]", "[]"));

    /** A line of the queue: its turn, what is wanted, for which mission, what became of it. */
    private record Row(String turn, String what, String state, SemanticColor color) {}

    /** The panel of whichever boat is selected first. */
    public BoatPanel(OperatorContext context) {
        super(new BorderLayout());
        this.context = context;
        BoatControl control = new BoatControl(context);
        queue = new RowTable<>(
                "boat-queue",
                "No mission wants anything of this boat.",
                Row::what,
                List.of(
                        RowColumn.words("Turn", 88, Row::turn),
                        RowColumn.words("Command", 0, Row::what),
                        RowColumn.<Row>words("State", 150, Row::state).colored(Row::color)));
        JPanel head = new JPanel(new MigLayout("insets 8 12 8 12, wrap 1, fillx, hidemode 3", "[grow]", "[]4[]4[]"));
        name.setName("boat-name");
        why.setName("boat-why");
        facts.setName("boat-facts");
        head.add(name, "wmin 0");
        head.add(why, "wmin 0");
        head.add(facts, "wmin 0");
        control.commands().forEach(command -> buttons.add(new CommandButton(command), "wmin 0"));
        add(head, BorderLayout.NORTH);
        add(queue);
        add(buttons, BorderLayout.SOUTH);
        context.boats().addListener(this::refresh);
        refresh();
    }

    /** Shows how the boat is now; to be called a few times a second. */
    public void refresh() {
        Optional<BoatSnapshot> boat =
                context.boats().first().flatMap(context.models().fleet()::boat);
        name.setFont(Fonts.heading());
        if (boat.isEmpty()) {
            name.setText("No boat is selected");
            name.setIcon(null);
            why.setText("Select one in the list or on the map.");
            why.setForeground(SemanticColor.MUTED.get());
            facts.setVisible(false);
            queue.show(List.of());
            return;
        }
        BoatSnapshot now = boat.get();
        name.setText(now.boat());
        name.setIcon(new MarkIcon(context.marks().of(now.boat())));
        why.setText(BoatWords.state(now));
        why.setToolTipText(why.getText());
        why.setForeground(BoatWords.color(BoatWords.trouble(now)).get());
        facts.setVisible(true);
        facts.setText(facts(now));
        facts.setForeground(SemanticColor.MUTED.get());
        queue.show(context.models().commands().snapshot().stream()
                .filter(commands -> commands.boat().equals(now.boat()))
                .findFirst()
                .map(BoatPanel::rows)
                .orElse(List.of()));
    }

    private String facts(BoatSnapshot boat) {
        List<String> words = new ArrayList<>();
        words.add(
                switch (boat.commander()) {
                    case THIS_BASE -> "commanded from here";
                    case BY_HAND -> "driven by hand";
                    case SOMEBODY_ELSE -> "commanded by another base";
                    case UNKNOWN -> "commander not known";
                });
        boat.mode()
                .ifPresent(mode ->
                        words.add("mode " + mode.name().toLowerCase(Locale.ROOT).replace('_', ' ')));
        words.add("battery " + BoatWords.battery(boat));
        words.add("link " + BoatWords.link(boat, context.nowMillis()));
        boat.pose()
                .ifPresent(pose -> words.add(String.format(
                        Locale.ROOT,
                        "%.6f, %.6f",
                        pose.position().latDeg(),
                        pose.position().lonDeg())));
        return String.join("  ·  ", words);
    }

    private static List<Row> rows(BoatCommands commands) {
        List<Row> rows = new ArrayList<>();
        String upload = commands.upload()
                .map(up ->
                        ", upload " + up.state().name().toLowerCase(Locale.ROOT).replace('_', ' '))
                .orElse("");
        commands.queue()
                .current()
                .ifPresent(entry -> rows.add(new Row(
                        "in force",
                        CommandWords.full(entry),
                        (entry.points() == 0 ? "running" : entry.visited() + " / " + entry.points() + upload),
                        SemanticColor.OK)));
        List<Entry> waiting = commands.queue().waiting();
        for (int i = 0; i < waiting.size(); i++) {
            rows.add(new Row(
                    (i + 1) + ". next",
                    CommandWords.full(waiting.get(i)),
                    waiting.get(i).why(),
                    SemanticColor.MUTED));
        }
        List<BoatCommands.Concluded> gone = commands.concluded();
        for (int i = gone.size() - 1; i >= 0; i--) {
            BoatCommands.Concluded each = gone.get(i);
            rows.add(new Row(
                    "over",
                    each.command().commandId() + ", mission " + each.command().mission(),
                    each.end().name().toLowerCase(Locale.ROOT) + (each.why().isEmpty() ? "" : ": " + each.why()),
                    each.end() == BoatCommands.End.FAILED ? SemanticColor.WARNING : SemanticColor.MUTED));
        }
        return rows;
    }
}
