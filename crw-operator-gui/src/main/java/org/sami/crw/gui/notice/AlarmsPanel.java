package org.sami.crw.gui.notice;

import java.awt.BorderLayout;
import java.util.List;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.stream.Stream;
import javax.swing.JPanel;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.operator.AlarmModel;
import org.sami.crw.operator.alarm.Alarm;
import org.sami.palette.SemanticColor;
import org.sami.spn.protocol.Priority;
import org.sami.ui.command.Command;
import org.sami.ui.replay.SessionClock;
import org.sami.ui.table.RowColumn;
import org.sami.ui.table.RowTable;
import org.sami.ui.table.TableTools;

/** The alarms: the worst first. Each is acknowledged, and can be muted. */
public final class AlarmsPanel extends JPanel {
    private final OperatorContext context;
    private final RowTable<Alarm> table;
    private final Command acknowledge;
    private final Command mute;

    private record Key(Alarm.Kind kind, String boat, String other) {}

    /**
     * The alarms of the session.
     *
     * @param pointing shows on the map what the selected alarm speaks of, by its boats and its text; none and nothing where none is selected
     */
    public AlarmsPanel(OperatorContext context, BiConsumer<List<String>, String> pointing) {
        super(new BorderLayout());
        this.context = context;
        table = new RowTable<>(
                "alarms-table",
                context.say(
                        "No alarm. Lost links, empty batteries, boats that drift, are outside of their water, too near"
                                + " to each other or without headway appear here."),
                alarm -> new Key(alarm.kind(), alarm.boat(), alarm.other()),
                List.of(
                        RowColumn.number("Since", 72, alarm -> SessionClock.text(alarm.sinceMillis())),
                        RowColumn.<Alarm>words("Alarm", 0, AlarmsPanel::text).colored(AlarmsPanel::color)));
        acknowledge = context.commands()
                .add(new Command("alarm-acknowledge", "Acknowledge alarms", this::acknowledgeSelected)
                        .withKey("ctrl shift M")
                        .withIcon("check")
                        .unless(this::whyNotAcknowledge));
        mute = context.commands()
                .add(new Command("alarm-mute", "Mute or unmute", this::muteSelected)
                        .withKey("ctrl U")
                        .withIcon("mute")
                        .unless(() -> table.selected().isPresent()
                                ? Optional.empty()
                                : Optional.of("select an alarm first")));
        table.addSelectionListener(() -> {
            acknowledge.refresh();
            mute.refresh();
            Optional<Alarm> chosen = table.selected();
            pointing.accept(
                    chosen.stream()
                            .flatMap(alarm -> Stream.of(alarm.boat(), alarm.other()))
                            .filter(boat -> !boat.isEmpty())
                            .toList(),
                    chosen.map(Alarm::text).orElse(""));
        });
        add(new TableTools(table, List.of(mute, acknowledge)));
        alarms().addListener(this::show);
        show(alarms().snapshot());
    }

    private AlarmModel alarms() {
        return context.models().alarms();
    }

    private void show(List<Alarm> now) {
        table.show(now);
        acknowledge.refresh();
        mute.refresh();
    }

    private Optional<String> whyNotAcknowledge() {
        return alarms().snapshot().stream().anyMatch(alarm -> !alarm.acknowledged())
                ? Optional.empty()
                : Optional.of("no alarm waits for it");
    }

    private void acknowledgeSelected() {
        List<Alarm> chosen = table.allSelected();
        (chosen.isEmpty() ? alarms().snapshot() : chosen).forEach(alarm -> alarms().acknowledge(alarm.number()));
    }

    private void muteSelected() {
        table.allSelected().forEach(alarm -> alarms().mute(alarm.kind(), alarm.boat(), !alarm.muted()));
    }

    private static String text(Alarm alarm) {
        String mark = alarm.kind().severity() == Priority.CRITICAL ? "▲ " : "△ ";
        String state = alarm.active() ? "" : " (over)";
        return mark + alarm.text() + state + (alarm.muted() ? " (muted)" : "");
    }

    private static SemanticColor color(Alarm alarm) {
        if (alarm.acknowledged() || !alarm.active()) {
            return SemanticColor.MUTED;
        }
        return alarm.kind().severity() == Priority.CRITICAL ? SemanticColor.CRITICAL : SemanticColor.WARNING;
    }
}
