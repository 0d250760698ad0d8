package org.sami.crw.gui.key;

import java.time.Instant;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.sami.boat.link.Role;
import org.sami.boat.link.security.Fingerprint;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.proxy.key.BaseKeys;
import org.sami.crw.proxy.key.FleetKey;
import org.sami.crw.proxy.status.LinkState;
import org.sami.crw.proxy.tcp.BaseProtection;
import org.sami.crw.session.key.KeyWork;
import org.sami.palette.SemanticColor;
import org.sami.ui.EventThread;
import org.sami.ui.sheet.WindowSheet;
import org.sami.ui.table.RowColumn;
import org.sami.ui.table.RowTable;
import org.sami.ui.value.WrappedText;

/** The keys of this base: its own, the boats that are paired with it, those that were withdrawn; and what is done with them. On the event thread. */
public final class KeysForm extends JPanel {
    private static final String WIDE = "growx, wmin 60";
    private static final DateTimeFormatter WHEN = DateTimeFormatter.ofPattern("yyyy-MM-dd HH:mm");

    private final OperatorContext context;
    private final KeyWork work;
    private final WrappedText fleet = new WrappedText("");
    private final JButton fleetKey;
    private final JPanel ofVehicles =
            new JPanel(new MigLayout("novisualpadding, insets 0, gap 8, fillx", "[grow,fill][]"));
    private final WrappedText own = new WrappedText("Reading the keys");
    private final WrappedText said = new WrappedText("");
    private final RowTable<Row> table;
    private final List<JButton> buttons = new ArrayList<>();
    private final JButton withdraw;
    private final JPanel actions = new JPanel(new MigLayout("novisualpadding, insets 0, gap 8", "", "[40!]"));
    private final JPanel below = new JPanel(new MigLayout("novisualpadding, insets 0, fillx", "[grow,fill]"));

    /** A key as it is shown. */
    private record Row(Fingerprint key, String name, String may, String seen, boolean withdrawn) {}

    /**
     * The keys that links of this process use.
     *
     * @param pair opens what pairs a boat
     */
    public KeysForm(OperatorContext context, Runnable pair) {
        super(new MigLayout(
                "novisualpadding, insets 8 12 12 12, gap 8, fillx, wrap 1, w 760::", "[grow,fill]", "[][][][]"));
        this.context = context;
        setName("keys-form");
        BaseProtection protection = BaseProtection.ofThisProcess();
        work = new KeyWork(
                new BaseKeys(protection.keysFolder()), EventThread.executor(), protection::readAgain, this::changed);
        table = new RowTable<>(
                "keys-table",
                context.say("No boat is paired with this base. Have a boat show its words, then press Pair a boat."),
                Row::key,
                List.of(
                        RowColumn.<Row>words("Name", 160, Row::name).colored(KeysForm::color),
                        RowColumn.<Row>words("This base may", 150, Row::may).colored(KeysForm::color),
                        RowColumn.<Row>words("Linked last", 150, Row::seen).colored(KeysForm::color),
                        RowColumn.<Row>words("Key", 0, row -> row.key().toString())
                                .colored(KeysForm::color)));
        own.setName("keys-own");
        fleet.setName("keys-fleet");
        ofVehicles.setOpaque(false);
        said.setName("keys-said");
        below.setName("keys-below");
        below.setOpaque(false);
        actions.setOpaque(false);
        actions.add(button("keys-pair", context.say("Pair a boat…"), 'T', pair), "growy");
        withdraw = button("keys-withdraw", "Withdraw…", 'W', this::askWithdraw);
        actions.add(withdraw, "growy");
        actions.add(button("keys-lost", "A laptop is lost…", 'L', this::askLost), "growy");
        actions.add(button("keys-export", "Export…", 'E', this::askExport), "growy");
        actions.add(button("keys-import", "Import…", 'I', this::askImport), "growy");
        fleetKey = button("keys-fleet-new", "New vehicle key…", 'K', this::makeFleetKey);
        ofVehicles.add(fleet, "wmin 60");
        ofVehicles.add(fleetKey, "hmin 40, top");
        add(own, WIDE);
        add(table, "growx, h 160:220:, hidemode 3");
        add(actions, WIDE + ", hidemode 3");
        add(ofVehicles, WIDE + ", hidemode 3");
        add(below, WIDE + ", hidemode 3");
        add(said, WIDE + ", hidemode 3");
        table.addSelectionListener(this::enableButtons);
        below.setVisible(false);
        work.read();
    }

    private JButton button(String name, String words, char mnemonic, Runnable pressed) {
        JButton button = new JButton(words);
        button.setName(name);
        button.setMnemonic(mnemonic);
        button.setToolTipText("Alt+" + mnemonic);
        button.addActionListener(e -> pressed.run());
        buttons.add(button);
        return button;
    }

    private static SemanticColor color(Row row) {
        return row.withdrawn() ? SemanticColor.MUTED : SemanticColor.TEXT;
    }

    private void changed() {
        work.listing().ifPresent(this::show);
        said.setText((work.isBad() ? "▲ " : "") + context.say(work.said()));
        said.setColor(work.isBad() ? SemanticColor.WARNING : SemanticColor.TEXT);
        said.setVisible(!work.said().isEmpty());
        enableButtons();
        fit();
    }

    private void enableButtons() {
        if (work.isBusy()) { // else it goes to what follows in the window, as the fleet stop; a button pressed by its
            // key may only be about to get it
            table.table().requestFocusInWindow();
        }
        buttons.forEach(button -> button.setEnabled(!work.isBusy()));
        boolean boat = table.selected().filter(row -> !row.withdrawn()).isPresent();
        withdraw.setEnabled(!work.isBusy() && boat);
        withdraw.setToolTipText(
                context.say(boat ? "Withdraw the key of the selected boat (Alt+W)" : "Select a boat first"));
    }

    private void show(BaseKeys.Listing listing) {
        own.setText("This base is " + BaseKeys.nameOfThisBase()
                + ". Its key, which another base withdraws where this laptop is" + " lost: " + listing.own()
                + ". Kept in " + work.folder() + ".");
        fleet.setText(fleetWords(listing.fleet()));
        fleetKey.setText(listing.fleet().isPresent() ? "New vehicle key…" : "Make a vehicle key");
        List<Row> rows = new ArrayList<>();
        listing.boats()
                .forEach(known -> rows.add(new Row(
                        known.boat().fingerprint(),
                        known.boat().name(),
                        known.boat().role() == Role.OBSERVER ? "observe and stop" : "command",
                        seen(known),
                        false)));
        listing.withdrawn().forEach(key -> rows.add(new Row(key, "–", "withdrawn", "", true)));
        table.show(rows);
    }

    private String fleetWords(Optional<FleetKey> key) {
        return key.map(kept -> "Key for vehicles of other makers (MAVLink signing): " + kept.fingerprint()
                        + ", here since " + when(kept.since())
                        + ". Export and Import take it along. Each vehicle gets it over"
                        + " the cable of its first port:\n" + giving())
                .orElse(
                        "No key for vehicles of other makers (MAVLink signing) yet: what is sent to them is not signed.");
    }

    /** The command that gives a vehicle the key. */
    private String giving() {
        String folder = work.folder().equals(BaseProtection.folderOfThisUser())
                ? ""
                : " --keys " + work.folder().toAbsolutePath();
        return "crw keys fleet" + folder + " --give mavlink:serial:/dev/ttyACM0:115200";
    }

    private static String when(Instant time) {
        return WHEN.format(time.atZone(ZoneId.systemDefault()));
    }

    private String seen(BaseKeys.Known known) {
        boolean linked = context.models()
                .fleet()
                .boat(known.boat().name())
                .map(BoatSnapshot::link)
                .filter(LinkState.LINKED::equals)
                .isPresent();
        return linked
                ? "linked now"
                : known.seenMillis()
                        .map(millis -> when(Instant.ofEpochMilli(millis)))
                        .orElse("never");
    }

    private void ask(KeyQuestion question) {
        below.removeAll();
        below.add(question, "growx");
        showQuestion(true);
        said.setVisible(false);
        fit();
        question.focusFirst();
    }

    /** A question takes the place of the list: in a small window with large letters there is no room for both. */
    private void showQuestion(boolean asked) {
        below.setVisible(asked);
        table.setVisible(!asked);
        actions.setVisible(!asked);
        ofVehicles.setVisible(!asked);
    }

    private void fit() {
        revalidate();
        WindowSheet.find(this).ifPresent(WindowSheet::fit);
    }

    private void leave() {
        below.removeAll();
        showQuestion(false);
        fit();
        repaint();
        table.table().requestFocusInWindow();
    }

    private void askWithdraw() {
        Optional<Row> chosen = table.selected().filter(row -> !row.withdrawn());
        chosen.ifPresent(row -> ask(new KeyQuestion(
                        "Withdraw the key of " + row.name()
                                + context.say("? This base links to it no longer, and tells the other boats, until"
                                        + " it is paired anew."),
                        this::leave)
                .withAnswer("Withdraw", question -> {
                    leave();
                    work.withdraw(row.key().toString());
                })));
    }

    private void askLost() {
        ask(new KeyQuestion(
                        context.say(
                                "Which laptop's key do boats refuse from now on? Its 64 digits stand in this panel of"
                                        + " the laptop, in crw keys list, and in what you have noted."),
                        this::leave)
                .withText("key", "Key of the lost laptop", "")
                .withAnswer("Withdraw", question -> {
                    work.withdraw(question.text("key"));
                    leave();
                }));
    }

    private void makeFleetKey() {
        Optional<FleetKey> present = work.listing().flatMap(BaseKeys.Listing::fleet);
        if (present.isEmpty()) {
            work.makeFleetKey();
            return;
        }
        ask(new KeyQuestion(
                        "Replace the key " + present.get().fingerprint()
                                + " by a new one, as when a laptop that has it is lost? Vehicles obey it until each is given the"
                                + " new one over the cable of its first port. A session that runs goes on with the vehicles"
                                + " that it has heard; one that starts later reaches none before it has the new key.",
                        this::leave)
                .withAnswer("Replace the key", question -> {
                    leave();
                    work.renewFleetKey();
                }));
    }

    private void askExport() {
        ask(new KeyQuestion(
                        context.say(
                                "All keys, also that of vehicles of other makers, go into one encrypted file, for a second laptop, which is then the same base"
                                        + " to the boats."),
                        this::leave)
                .withText("file", "File", System.getProperty("user.home") + "/fleet.keys")
                .withPassword("password", "Password, 8 characters or more")
                .withPassword("repeated", "The same again")
                .withAnswer(
                        "Export",
                        question -> question.path("file").ifPresent(file -> {
                            work.exportTo(file, question.password("password"), question.password("repeated"));
                            leave();
                        })));
    }

    private void askImport() {
        ask(new KeyQuestion(
                        "The keys of the file replace those above, which are given up: what only they were paired with"
                                + " is paired anew.",
                        this::leave)
                .withText("file", "File", System.getProperty("user.home") + "/fleet.keys")
                .withPassword("password", "Password of the file")
                .withAnswer(
                        "Replace the keys",
                        question -> question.path("file").ifPresent(file -> {
                            work.importFrom(file, question.password("password"));
                            leave();
                        })));
    }
}
