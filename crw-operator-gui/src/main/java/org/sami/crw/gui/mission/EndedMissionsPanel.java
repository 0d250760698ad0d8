package org.sami.crw.gui.mission;

import java.awt.BorderLayout;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.LongConsumer;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.operator.mission.MissionSnapshot;
import org.sami.crw.operator.mission.MissionsSnapshot;
import org.sami.palette.SemanticColor;
import org.sami.spn.protocol.Outcome;
import org.sami.ui.command.Command;
import org.sami.ui.replay.SessionClock;
import org.sami.ui.table.RowColumn;
import org.sami.ui.table.RowTable;
import org.sami.ui.table.TableTools;

/** The missions that have ended, the latest first; each can be shown again as it was at its end. On the event thread. */
final class EndedMissionsPanel extends JPanel {
    private final RowTable<Row> table;
    private final Command show;

    /** A mission that has ended. */
    private record Row(long mission, String words, String plan, Optional<Outcome> outcome, String at, String took) {
        static Row of(MissionSnapshot mission) {
            long end = mission.endedAtMillis().orElse(mission.startedAtMillis());
            return new Row(
                    mission.id(),
                    mission.words(),
                    mission.words().equals(mission.title()) ? "" : mission.title(),
                    mission.outcome(),
                    SessionClock.text(end),
                    SessionClock.text(Math.max(0, end - mission.startedAtMillis())));
        }
    }

    /** @param shown is given the id of a mission that is to be shown again */
    EndedMissionsPanel(OperatorContext context, LongConsumer shown) {
        super(new BorderLayout());
        setName("missions-over");
        table = new RowTable<>(
                "missions-over-table",
                "No mission has ended. Each that does leaves the tabs and is found here, as it was at its end.",
                Row::mission,
                List.of(
                        RowColumn.words("Mission", 0, Row::words),
                        RowColumn.words("Plan", 170, Row::plan).asSpare(),
                        RowColumn.<Row>words("Outcome", 96, EndedMissionsPanel::outcome)
                                .colored(EndedMissionsPanel::color),
                        RowColumn.number("At", 76, Row::at),
                        RowColumn.<Row>number("Took", 76, Row::took).asSpare()));
        table.showOneLine();
        show = context.commands()
                .add(new Command(
                                "mission-show-ended",
                                "Show the ended mission",
                                () -> table.selected().ifPresent(row -> shown.accept(row.mission())))
                        .withKey("ctrl shift O")
                        .withIcon("net")
                        .unless(() -> table.selected().isPresent()
                                ? Optional.empty()
                                : Optional.of("select a mission in the list of ended ones first")));
        table.addSelectionListener(show::refresh);
        table.table().getInputMap(JComponent.WHEN_FOCUSED).put(KeyStroke.getKeyStroke("ENTER"), "show");
        table.table().getActionMap().put("show", show);
        table.table().addMouseListener(new MouseAdapter() {
            @Override
            public void mouseClicked(MouseEvent clicked) {
                if (clicked.getClickCount() == 2 && show.whyNot().isEmpty()) {
                    show.run();
                }
            }
        });
        add(new TableTools(table, List.of(show)));
    }

    private static String outcome(Row row) {
        return row.outcome()
                .map(outcome -> outcome.name().toLowerCase(Locale.ROOT))
                .orElse("");
    }

    private static SemanticColor color(Row row) {
        return row.outcome()
                .map(outcome -> switch (outcome) {
                    case ENDED, COMPLETED -> SemanticColor.OK;
                    case ABORTED, HALTED -> SemanticColor.WARNING;
                })
                .orElse(SemanticColor.TEXT);
    }

    /** Shows which have ended now. */
    void show(MissionsSnapshot missions) {
        table.show(missions.ended().stream().map(Row::of).toList());
        show.refresh();
    }

    /** How many have ended. */
    int count() {
        return table.table().getRowCount();
    }
}
