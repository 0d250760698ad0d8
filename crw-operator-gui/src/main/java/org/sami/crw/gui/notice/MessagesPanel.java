package org.sami.crw.gui.notice;

import java.awt.BorderLayout;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.LongConsumer;
import javax.swing.JPanel;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.gui.context.UseWatch;
import org.sami.crw.gui.picture.PictureChoice;
import org.sami.crw.gui.picture.ShownPictures;
import org.sami.crw.gui.picture.ThumbnailIcon;
import org.sami.crw.message.MessageEntry;
import org.sami.crw.message.OperatorMessage;
import org.sami.crw.operator.MessageList;
import org.sami.palette.SemanticColor;
import org.sami.spn.protocol.Priority;
import org.sami.ui.command.Command;
import org.sami.ui.replay.SessionClock;
import org.sami.ui.table.RowColumn;
import org.sami.ui.table.RowTable;
import org.sami.ui.table.TableTools;

/** The messages: the most urgent first, of equal ones the newest. */
public final class MessagesPanel extends JPanel {
    private final OperatorContext context;
    private final RowTable<MessageEntry> table;
    private final ShownPictures pictures;
    private final Command acknowledge;
    private final Command enlarge;
    private final Optional<Command> moment;

    /**
     * The messages of the session.
     *
     * @param pictures of the session's boats, of which messages show some
     * @param pointing shows on the map what the selected message speaks of, by its boats and its text; none and nothing where none is selected
     */
    public MessagesPanel(OperatorContext context, BiConsumer<List<String>, String> pointing, ShownPictures pictures) {
        super(new BorderLayout());
        this.pictures = pictures;
        this.context = context;
        table = new RowTable<>(
                "messages-table",
                "No message yet. What plans tell the operator appears here, the most urgent first.",
                MessageEntry::number,
                List.of(
                        RowColumn.number(
                                "At",
                                72,
                                entry -> SessionClock.text(entry.message().atMillis())),
                        RowColumn.<MessageEntry>words(
                                        "Message",
                                        0,
                                        entry -> mark(entry) + entry.message().text())
                                .colored(MessagesPanel::color)
                                .withIcon(entry -> ThumbnailIcon.of(pictures, picturesOf(entry)))));
        acknowledge = context.commands()
                .add(new Command("message-acknowledge", "Acknowledge messages", this::acknowledgeSelected)
                        .withKey("ctrl M")
                        .withIcon("check")
                        .unless(this::whyNotAcknowledge));
        enlarge = context.commands()
                .add(new Command("message-pictures", "Enlarge the message's pictures", this::openPictures)
                        .withKey("alt M")
                        .withIcon("picture")
                        .unless(this::whyNoPictures));
        table.addSelectionListener(acknowledge::refresh);
        table.addSelectionListener(enlarge::refresh);
        table.addSelectionListener(() -> {
            Optional<OperatorMessage> chosen = table.selected().map(MessageEntry::message);
            pointing.accept(
                    chosen.map(OperatorMessage::boats).orElse(List.of()),
                    chosen.map(OperatorMessage::text).orElse(""));
        });
        moment = context.shown().moments().map(this::moment);
        pictures.addListener(() -> {
            enlarge.refresh();
            table.repaint();
        });
        add(new TableTools(
                table, moment.map(one -> List.of(enlarge, acknowledge, one)).orElse(List.of(enlarge, acknowledge))));
        MessageList messages = context.models().messages();
        UseWatch.on(table.table(), table, messages::touched, messages::focus);
        messages.addListener(this::show);
        show(messages.snapshot());
    }

    private Command moment(LongConsumer goTo) {
        Command goes = context.commands()
                .add(new Command(
                                "replay-message",
                                "Show the moment of this message",
                                () -> table.selected()
                                        .ifPresent(entry ->
                                                goTo.accept(entry.message().atMillis())))
                        .withKey("ctrl J")
                        .withIcon("clock")
                        .unless(() -> table.selected().isPresent()
                                ? Optional.empty()
                                : Optional.of("select a message first")));
        table.addSelectionListener(goes::refresh);
        return goes;
    }

    private List<PictureChoice> picturesOf(MessageEntry entry) {
        return pictures.with(entry.message().map(), entry.message().atMillis());
    }

    /** Those of the selected message; of the newest that has some, where none is selected. */
    private Optional<PictureChoice> firstPicture() {
        return table.selected().map(List::of).orElse(context.models().messages().snapshot()).stream()
                .sorted(Comparator.comparingLong(MessageEntry::number).reversed())
                .flatMap(entry -> picturesOf(entry).stream())
                .findFirst();
    }

    private Optional<String> whyNoPictures() {
        return firstPicture().isPresent()
                ? Optional.empty()
                : Optional.of(
                        table.selected().isPresent() ? "this message has no pictures" : "no message has pictures");
    }

    private void openPictures() {
        firstPicture().ifPresent(pictures::open);
    }

    private void show(List<MessageEntry> entries) {
        table.show(entries);
        acknowledge.refresh();
        enlarge.refresh();
        moment.ifPresent(Command::refresh);
    }

    private Optional<String> whyNotAcknowledge() {
        return context.models().messages().snapshot().stream().anyMatch(entry -> !entry.acknowledged())
                ? Optional.empty()
                : Optional.of("all messages are acknowledged");
    }

    /** Those that are selected; all where none is. */
    private void acknowledgeSelected() {
        List<MessageEntry> chosen = table.allSelected();
        List<MessageEntry> meant =
                chosen.isEmpty() ? context.models().messages().snapshot() : chosen;
        meant.forEach(entry -> context.models().messages().acknowledge(entry.number()));
    }

    private static String mark(MessageEntry entry) {
        return switch (entry.message().priority()) {
            case CRITICAL -> "▲ ";
            case HIGH -> "△ ";
            default -> "";
        };
    }

    private static SemanticColor color(MessageEntry entry) {
        if (entry.acknowledged()) {
            return SemanticColor.MUTED;
        }
        Priority priority = entry.message().priority();
        return priority == Priority.CRITICAL
                ? SemanticColor.CRITICAL
                : priority == Priority.HIGH ? SemanticColor.WARNING : SemanticColor.TEXT;
    }
}
