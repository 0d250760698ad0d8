package org.sami.crw.gui.near;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.stream.Stream;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import javax.swing.Timer;
import net.miginfocom.swing.MigLayout;
import org.sami.crw.gui.boat.BoatNameColumn;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.session.near.ConnectAll;
import org.sami.crw.session.near.NearBoats;
import org.sami.crw.session.near.NearRow;
import org.sami.palette.SemanticColor;
import org.sami.ui.command.Command;
import org.sami.ui.command.CommandButton;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.LookColors;
import org.sami.ui.table.RowColumn;
import org.sami.ui.table.RowTable;
import org.sami.ui.table.TableFit;
import org.sami.ui.value.WrappedText;

/**
 * The boats near, one line each: address, charge, whether it is connected or can be, and whether it is ready for a mission or why not. Connects all with one
 * press, or those that are selected. On the event thread.
 */
final class NearForm extends JPanel {
    private static final String WIDE = "growx, wmin 60";
    private static final String EMPTY =
            "No boat announces itself yet. Switch boats on, in the same network as this laptop: each appears here"
                    + " within seconds. Where the network passes no announcements, connect by address (Ctrl+B).";
    private static final int REFRESH_MS = 500; // ages grow by themselves

    private static final int LEAST_PX = 120;
    private static final int LEAST_ROWS = 4;

    private final MigLayout layout = new MigLayout(
            "novisualpadding, insets 4 12 12 12, gap 8, fillx, wrap 1, hidemode 3, w 980::",
            "[grow,fill]",
            "[][][grow,fill][][]");
    private final OperatorContext context;
    private final NearBoats boats;
    private final Consumer<NearRow> pairing;
    private final JLabel count = new JLabel(" ");
    private final WrappedText problems = new WrappedText("");
    private final WrappedText said = new WrappedText("");
    private final RowTable<CheckedBoat> table;
    private final Timer refresh = new Timer(REFRESH_MS, e -> refresh());
    private final TableFit tableFit;
    private Supplier<String> saying = () -> "";
    private final Command connect;
    private final Command pair;

    /**
     * A list that follows boats.
     *
     * @param pairing pairs one
     */
    NearForm(OperatorContext context, NearBoats boats, Consumer<NearRow> pairing) {
        setLayout(layout);
        this.context = context;
        this.boats = boats;
        this.pairing = pairing;
        setName("boats-near");
        table = new RowTable<>(
                "boats-near-table",
                context.say(EMPTY),
                one -> one.row().address(),
                List.of(
                        BoatNameColumn.names(context, CheckedBoat::name),
                        RowColumn.<CheckedBoat>words(
                                        "Address",
                                        150,
                                        one -> one.row().address().toString())
                                .keepingEnds()
                                .asSpare(),
                        RowColumn.number("Battery", 68, CheckedBoat::battery),
                        RowColumn.<CheckedBoat>words(
                                        "Link",
                                        150,
                                        one -> context.say(one.row().words()))
                                .colored(CheckedBoat::linkColor),
                        RowColumn.<CheckedBoat>words("Ready for a mission", 0, one -> context.say(one.checkWords()))
                                .colored(CheckedBoat::checkColor)));
        table.showOneLine();
        table.table().getAccessibleContext().setAccessibleName(context.say("Boats near"));
        Command all = new Command("near-connect-all", "Connect all", this::connectAll).withIcon("connect");
        connect = new Command("near-connect", "Connect", this::connectSelected).unless(this::whyNotConnect);
        pair = new Command("near-pair", "Pair…", this::pairSelected)
                .withIcon("link")
                .unless(this::whyNotPair);
        count.setName("boats-near-count");
        said.setName("boats-near-said");
        problems.setName("boats-near-problems");
        problems.setColor(SemanticColor.WARNING);
        LookColors.foreground(count, SemanticColor.TEXT);
        add(count, WIDE);
        add(buttons(all), WIDE);
        add(table, "growx");
        tableFit = new TableFit(this, layout, table, LEAST_PX, LEAST_ROWS);
        add(said, WIDE);
        add(problems, WIDE);
        bind("ENTER", "near-open", new Command("near-enter", "Connect or pair", this::open), table.table());
        table.addSelectionListener(this::refreshCommands);
        boats.onChange(this::refresh);
        addHierarchyListener(event -> {
            if (isShowing()) {
                refresh.start();
            } else {
                refresh.stop();
            }
        });
        refresh();
    }

    private JPanel buttons(Command all) {
        JPanel row = new JPanel(new MigLayout("novisualpadding, insets 0, gap 8", "[][][]push[]", "[40!]"));
        row.setOpaque(false);
        CommandButton first = CommandButton.primary(all, "connect");
        bind("ENTER", "press", all, first);
        row.add(first, "growy");
        row.add(new CommandButton(connect), "growy");
        row.add(new CommandButton(pair), "growy");
        CommandButton address = new CommandButton(context.commands().get("boat-connect"));
        address.setText("By address…");
        row.add(address, "growy");
        return row;
    }

    private static void bind(String key, String name, Command command, JComponent where) {
        where.getInputMap(JComponent.WHEN_FOCUSED).put(KeyStroke.getKeyStroke(key), name);
        where.getActionMap().put(name, command);
    }

    private Stream<NearRow> selected() {
        return table.allSelected().stream().map(CheckedBoat::row);
    }

    private Optional<String> whyNotConnect() {
        if (selected().anyMatch(NearRow::canConnect)) {
            return Optional.empty();
        }
        return Optional.of(selected()
                .findFirst()
                .map(row -> row.name() + ": " + row.whyNot().orElseGet(row::words))
                .orElse(context.say("select a boat first")));
    }

    private Optional<String> whyNotPair() {
        Optional<NearRow> one = table.selected().map(CheckedBoat::row);
        if (one.isEmpty()) {
            return Optional.of(context.say("select one boat first"));
        }
        return one.filter(NearRow::needsPairing).isPresent()
                ? Optional.empty()
                : Optional.of(
                        one.get().name() + " is not to be paired: " + one.get().words());
    }

    private void connectAll() {
        ConnectAll all = boats.connectAll(context.notices()::refused);
        say(() -> all.words(boats.list()));
    }

    private void connectSelected() {
        List<NearRow> rows = selected().filter(NearRow::canConnect).toList();
        rows.forEach(row -> boats.connect(row.address(), context.notices()::refused));
        ConnectAll some = new ConnectAll(rows.stream().map(NearRow::address).toList(), List.of());
        say(() -> some.words(boats.list()));
    }

    private void pairSelected() {
        table.selected().map(CheckedBoat::row).ifPresent(pairing);
    }

    /** Connects or pairs the selected boat, whichever it needs next. */
    private void open() {
        if (whyNotConnect().isEmpty()) {
            connectSelected();
        } else if (whyNotPair().isEmpty()) {
            pairSelected();
        } else {
            String why = whyNotConnect().orElse("");
            say(() -> why);
        }
    }

    private void say(Supplier<String> words) {
        saying = words;
        refresh();
    }

    private void refreshCommands() {
        connect.refresh();
        pair.refresh();
    }

    /** Shows the boats as they are now. */
    private void refresh() {
        List<CheckedBoat> now = CheckedBoat.of(boats.list(), context.models(), context.launchFacts());
        now.forEach(one -> one.known().ifPresent(boat -> context.marks().of(boat.boat())));
        table.show(now);
        count.setFont(Fonts.heading());
        count.setText(context.say(now.isEmpty() ? "Looking for boats" : CheckedBoat.count(now)));
        String wrong = String.join(". ", boats.list().problems());
        problems.setText(wrong.isEmpty() ? "" : "▲ " + context.say(wrong));
        problems.setVisible(!wrong.isEmpty());
        said.setText(context.say(saying.get()));
        said.setVisible(!said.getText().isEmpty());
        refreshCommands();
        tableFit.fit(now.size(), said.getText());
    }
}
