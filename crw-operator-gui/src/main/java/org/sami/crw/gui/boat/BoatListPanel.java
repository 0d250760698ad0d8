package org.sami.crw.gui.boat;

import java.awt.BorderLayout;
import java.awt.CardLayout;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import javax.swing.JPanel;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.gui.picture.ShownPictures;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.operator.boat.FleetRows;
import org.sami.crw.operator.boat.UnreachedBoat;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.palette.SemanticColor;
import org.sami.spn.value.NaturalOrder;
import org.sami.ui.command.Command;
import org.sami.ui.table.RowColumn;
import org.sami.ui.table.RowTable;
import org.sami.ui.window.WindowSettings;

/** The boats, worst first: what each does or why it stands, charge, speed, path, age of the link. Shows each in its own mark. */
public final class BoatListPanel extends JPanel {
    private static final String PICTURES = "boats-pictures";
    private static final String LINES = "lines";
    private static final String CARDS = "cards";
    private static final int ALTITUDE_COLUMN = 3; // behind the battery

    private static final Comparator<Shown> WORST_FIRST = Comparator.comparingInt(
                    (Shown shown) -> BoatWords.trouble(shown.boat()))
            .reversed()
            .thenComparing(shown -> shown.boat().boat(), NaturalOrder.INSTANCE);

    private final OperatorContext context;
    private final RowTable<Shown> table;
    private final CardLayout looks = new CardLayout();
    private final JPanel deck = new JPanel(looks);
    private final BoatCards cards;
    private final WindowSettings settings;
    private boolean withPictures;

    /** A boat as it is shown; its link's age changes by itself. */
    private record Shown(BoatSnapshot boat, String link, boolean stale) {
        String name() {
            return boat.boat();
        }
    }

    /**
     * The boats of the session.
     *
     * @param pictures that they take
     * @param settings keep whether each is shown with its newest picture
     */
    public BoatListPanel(OperatorContext context, ShownPictures pictures, WindowSettings settings) {
        super(new BorderLayout());
        this.context = context;
        this.settings = settings;
        table = new RowTable<>(
                "boats-table",
                context.say(
                        context.whyNotAct().isEmpty()
                                ? "No boat is known. Connect one (Ctrl+B), or start the plan that connects boats; each"
                                        + " appears here with what it does."
                                : "No boat is known. Each that the session connects appears here with what it does."),
                Shown::name,
                columns(context));
        table.showOneLine();
        table.table().getAccessibleContext().setAccessibleName(context.say("Boats"));
        BoatNameColumn.shareSelection(context, table, Shown::name);
        Command giveUp = context.commands()
                .add(new Command("address-give-up", "Give up the address", this::giveUpAddress)
                        .withKey("alt shift X")
                        .withIcon("link-lost")
                        .unless(() -> selectedAddress().isPresent()
                                ? context.whyNotAct()
                                : Optional.of("select an address that does not answer")));
        table.addSelectionListener(giveUp::refresh);
        context.models()
                .fleet()
                .addListener(boats -> context.boats()
                        .retain(boats.stream().map(BoatSnapshot::boat).toList()));
        cards = new BoatCards(context, pictures);
        deck.add(table, LINES);
        deck.add(cards, CARDS);
        add(deck);
        context.commands()
                .add(new Command("boats-pictures", "Boats with their newest pictures, or a line each", this::toggle)
                        .withKey("alt shift V")
                        .withIcon("picture"));
        showPictures(Boolean.parseBoolean(settings.text(PICTURES)));
        refresh();
    }

    private void toggle() {
        showPictures(!withPictures);
    }

    /** Shows each boat with its newest picture, or in a line of a table; kept with the window's settings. */
    public void showPictures(boolean shown) {
        withPictures = shown;
        looks.show(deck, shown ? CARDS : LINES);
        if (shown != Boolean.parseBoolean(settings.text(PICTURES))) {
            settings.keep(PICTURES, Boolean.toString(shown));
        }
        refresh();
    }

    private List<RowColumn<Shown>> columns(OperatorContext of) {
        List<RowColumn<Shown>> columns = new ArrayList<>(List.of(
                BoatNameColumn.names(of, Shown::name),
                RowColumn.<Shown>words(
                                "What it does", 0, shown -> of.sayOf(shown.name(), BoatWords.brief(shown.boat())))
                        .colored(shown -> BoatWords.color(BoatWords.trouble(shown.boat()))),
                number("Battery", 68, shown -> BoatWords.battery(shown.boat())).colored(shown -> batteryColor(shown)),
                number("Speed", 72, shown -> BoatWords.speed(shown.boat())).asSpare(),
                number("Path", 72, shown -> BoatWords.path(shown.boat())).asSpare(),
                RowColumn.<Shown>number("Link", 90, Shown::link)
                        .colored(shown -> shown.stale() ? SemanticColor.CRITICAL : SemanticColor.TEXT)
                        .asLastSpare())); // what it does says when the link is lost
        if (of.robots() != RobotKind.BOAT) {
            columns.add(
                    ALTITUDE_COLUMN,
                    number(
                            "Altitude",
                            76,
                            shown -> of.kindOf(shown.name()) == RobotKind.COPTER
                                    ? BoatWords.altitude(shown.boat())
                                    : ""));
        }
        return columns;
    }

    private static RowColumn<Shown> number(String title, int width, Function<Shown, String> text) {
        return RowColumn.<Shown>number(title, width, text)
                .colored(shown -> shown.stale() ? SemanticColor.STALE : SemanticColor.TEXT);
    }

    private static SemanticColor batteryColor(Shown shown) {
        return BoatCard.batteryColor(shown.boat(), shown.stale());
    }

    /** The address that is selected and does not answer; for a boat that is known by its name its address as well. */
    private Optional<UnreachedBoat> selectedAddress() {
        return table.selected()
                .flatMap(shown -> context.models().unreached().snapshot().stream()
                        .filter(one -> one.name().equals(shown.name()))
                        .findFirst());
    }

    private void giveUpAddress() {
        selectedAddress()
                .ifPresent(one -> context.tell(
                        context.session().fleet().disconnect(BoatAddress.parse(one.address())),
                        one.address() + " is given up"));
    }

    /** Shows them as they are known now; to be called a few times a second, as ages change by themselves. */
    public void refresh() {
        long now = context.nowMillis();
        List<BoatSnapshot> boats = context.models().fleet().snapshot();
        boats.forEach(boat -> context.marks().of(boat.boat()));
        List<Shown> rows = FleetRows.of(boats, context.models().unreached().snapshot(), now).stream()
                .map(boat -> new Shown(boat, BoatWords.link(boat, now), BoatWords.isStale(boat, now)))
                .sorted(WORST_FIRST)
                .toList();
        table.show(rows);
        if (withPictures) {
            cards.show(rows.stream()
                    .map(row -> BoatCard.of(context, row.boat(), row.link(), row.stale()))
                    .toList());
        }
    }
}
