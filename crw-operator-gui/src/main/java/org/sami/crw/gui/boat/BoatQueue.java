package org.sami.crw.gui.boat;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.operator.boat.BoatCommands;
import org.sami.crw.operator.boat.BoatCommands.Concluded;
import org.sami.crw.proxy.command.Upload;
import org.sami.crw.proxy.explanation.MissionTitles;
import org.sami.crw.proxy.queue.CommandQueueSnapshot.Entry;
import org.sami.palette.SemanticColor;
import org.sami.ui.command.Command;
import org.sami.ui.table.RowColumn;
import org.sami.ui.table.RowTable;

/** The command queue of a boat: what is in force, who keeps the boat for itself, what waits and why, what became of the last ones. */
final class BoatQueue {
    private final OperatorContext context;
    private final RowTable<Row> table;
    private final Command cancel;
    private Optional<String> shown = Optional.empty();

    /**
     * A line of the queue: its turn, the command and its mission, its state.
     *
     * @param command id of a command that can be cancelled; empty for a line that is none, or is over
     */
    private record Row(String turn, String what, String state, SemanticColor color, Optional<String> command) {}

    BoatQueue(OperatorContext context) {
        this.context = context;
        table = new RowTable<>(
                "boat-queue",
                context.say(
                        "Nobody wants anything of this boat. Commands of missions stand here: the one in force, those"
                                + " that wait and why."),
                row -> row.command().orElse(row.turn() + row.what()),
                List.of(
                        RowColumn.words("Turn", 88, Row::turn),
                        RowColumn.words("Command", 0, row -> context.say(row.what())),
                        RowColumn.<Row>words("State", 190, row -> context.say(row.state()))
                                .colored(Row::color)));
        table.table().getAccessibleContext().setAccessibleName(context.say("Boat queue"));
        cancel = context.commands()
                .add(new Command("boat-cancel-command", "Cancel the command", this::cancel)
                        .withKey("ctrl DELETE")
                        .withIcon("abort")
                        .unless(() -> chosen().isPresent()
                                ? Optional.empty()
                                : Optional.of("select a command in the boat's queue first")));
        table.addSelectionListener(cancel::refresh);
    }

    RowTable<?> table() {
        return table;
    }

    Command cancelCommand() {
        return cancel;
    }

    /** Shows the queue of a boat as it is now. */
    void show(Optional<String> boat) {
        shown = boat;
        table.show(context.models().commands().snapshot().stream()
                .filter(commands -> boat.filter(commands.boat()::equals).isPresent())
                .findFirst()
                .map(this::rows)
                .orElse(List.of()));
        cancel.refresh();
    }

    private Optional<String> chosen() {
        return table.selected().flatMap(Row::command);
    }

    private void cancel() {
        String boat = shown.orElseThrow();
        chosen().ifPresent(command -> context.tell(
                context.session().fleet().cancel(boat, command),
                boat + ": the command is cancelled; its mission hears that it failed"));
    }

    private List<Row> rows(BoatCommands commands) {
        MissionTitles titles = context.titles();
        List<Row> rows = new ArrayList<>();
        commands.queue()
                .current()
                .ifPresent(entry -> rows.add(row(
                        "in force",
                        CommandWords.full(entry, titles),
                        entry,
                        state(entry, commands.upload()),
                        SemanticColor.OK)));
        commands.queue()
                .blockedBy()
                .ifPresent(mission -> rows.add(new Row(
                        "block",
                        titles.words(mission) + " keeps the boat for itself",
                        "others wait",
                        SemanticColor.WARNING,
                        Optional.empty())));
        List<Entry> waiting = commands.queue().waiting();
        for (int i = 0; i < waiting.size(); i++) {
            Entry entry = waiting.get(i);
            rows.add(row(
                    (i + 1) + ". next",
                    CommandWords.full(entry, titles),
                    entry,
                    entry.why().words(MissionTitles.NONE), // the row of the block names its plan
                    SemanticColor.MUTED));
        }
        List<Concluded> gone = commands.concluded();
        for (int i = gone.size() - 1; i >= 0; i--) {
            rows.add(over(gone.get(i), titles));
        }
        return rows;
    }

    private static Row row(String turn, String what, Entry entry, String state, SemanticColor color) {
        return new Row(turn, what, state, color, Optional.of(entry.command().commandId()));
    }

    private static String state(Entry entry, Optional<Upload> upload) {
        String sent = upload.filter(up -> up.commandId().equals(entry.command().commandId()))
                .map(up -> ", "
                        + switch (up.state()) {
                            case SENT -> "sent";
                            case ACKNOWLEDGED -> "acknowledged";
                            case READ_BACK_EQUAL -> "read back equal";
                            case TAKEN_OVER -> "held already, read back equal";
                            case FAILED -> "not sent: " + up.why();
                        })
                .orElse("");
        return (entry.points() == 0 ? "running" : entry.visited() + " / " + entry.points()) + sent;
    }

    private static Row over(Concluded gone, MissionTitles titles) {
        return new Row(
                "over",
                CommandWords.what(gone.command()) + ", "
                        + titles.words(gone.command().mission()),
                gone.end().name().toLowerCase(Locale.ROOT) + (gone.why().isEmpty() ? "" : ": " + gone.why()),
                gone.end() == BoatCommands.End.FAILED ? SemanticColor.WARNING : SemanticColor.MUTED,
                Optional.empty());
    }
}
