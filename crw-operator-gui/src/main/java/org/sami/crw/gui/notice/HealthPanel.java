package org.sami.crw.gui.notice;

import java.awt.BorderLayout;
import java.util.List;
import java.util.Optional;
import java.util.function.BiConsumer;
import javax.swing.JPanel;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.operator.health.Health;
import org.sami.crw.operator.health.HealthEntry;
import org.sami.palette.SemanticColor;
import org.sami.spn.protocol.Priority;
import org.sami.ui.replay.SessionClock;
import org.sami.ui.table.RowColumn;
import org.sami.ui.table.RowTable;

/** Every fault that lasts, the worst first: since when, what is wrong, what to do. None goes before it is over. On the event thread. */
public final class HealthPanel extends JPanel {
    private final RowTable<HealthEntry> table;

    /**
     * The faults of the session.
     *
     * @param pointing shows on the map what the selected fault speaks of, by its boat and its text; none and nothing where none is selected
     */
    public HealthPanel(OperatorContext context, BiConsumer<List<String>, String> pointing) {
        super(new BorderLayout());
        table = new RowTable<>(
                "health-table",
                context.say("No fault. What lasts stands here until it is over: engine, journal, disk, missions that"
                        + " cannot go on, boats, links."),
                HealthEntry::number,
                List.of(
                        RowColumn.number("Since", 72, entry -> SessionClock.text(entry.sinceMillis())),
                        RowColumn.<HealthEntry>words("What is wrong, and what to do", 0, HealthPanel::what)
                                .colored(HealthPanel::color)));
        table.addSelectionListener(() -> {
            Optional<HealthEntry> chosen = table.selected();
            pointing.accept(
                    chosen.map(entry -> entry.fault().boat()).filter(boat -> !boat.isEmpty()).stream()
                            .toList(),
                    chosen.map(entry -> entry.fault().text()).orElse(""));
        });
        add(table);
        context.models().health().addListener(this::show);
        show(context.models().health().snapshot());
    }

    private void show(Health health) {
        table.show(health.entries());
    }

    private static String what(HealthEntry entry) {
        return (entry.severity() == Priority.CRITICAL ? "▲ " : "△ ")
                + entry.fault().whole();
    }

    private static SemanticColor color(HealthEntry entry) {
        return entry.severity() == Priority.CRITICAL ? SemanticColor.CRITICAL : SemanticColor.WARNING;
    }
}
