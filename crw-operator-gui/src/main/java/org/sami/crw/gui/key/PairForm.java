package org.sami.crw.gui.key;

import java.awt.Component;
import java.awt.event.ActionEvent;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Set;
import javax.swing.AbstractAction;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import net.miginfocom.swing.MigLayout;
import org.sami.boat.link.Role;
import org.sami.boat.link.security.PairingCode;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.operator.boat.UnreachedBoat;
import org.sami.crw.proxy.key.BaseKeys;
import org.sami.crw.proxy.tcp.BaseProtection;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.proxy.tcp.BoatPairing;
import org.sami.crw.proxy.tcp.PairingText;
import org.sami.crw.session.key.PairingAttempt;
import org.sami.crw.session.key.PairingDraft;
import org.sami.palette.SemanticColor;
import org.sami.ui.EventThread;
import org.sami.ui.sheet.WindowSheet;
import org.sami.ui.value.TextChanges;
import org.sami.ui.value.WrappedText;

/**
 * Pairs a boat: its address, the six words that it shows or the text of its QR code, and what this base may do; then the check code that both sides show, which a
 * person compares. On the event thread; the boat is asked off it.
 */
final class PairForm extends JPanel {
    private static final String TALL = "hmin 40";
    private static final String WIDE = "span, growx, wmin 60";
    private static final Set<String> THIS_MACHINE = Set.of("127.0.0.1", "localhost", "::1");

    private final OperatorContext context;
    private final BaseProtection protection;
    private final JTextField address = new JTextField(30);
    private final JComboBox<String> unpaired = new JComboBox<>();
    private final JTextField said = new JTextField(30);
    private final JComboBox<String> role;
    private final JButton picture = new JButton("Read a picture of the QR code…");
    private final JButton pair = new JButton("Pair");
    private final WrappedText offered = new WrappedText("");
    private final WrappedText judged = new WrappedText("");
    private final CheckCodePanel check;
    private Optional<PairingAttempt> attempt = Optional.empty();
    private Runnable choosePicture = () -> {};

    /** An empty form. */
    PairForm(OperatorContext context, BaseProtection protection) {
        super(new MigLayout(
                "novisualpadding, insets 8 12 12 12, gap 8, fillx, wrap 2, hidemode 3, w 620::", "[][grow,fill]"));
        this.context = context;
        this.protection = protection;
        role = new JComboBox<>(
                new String[] {context.say("Command the boat, and stop it"), context.say("Observe the boat, and stop it")
                });
        check = new CheckCodePanel(context::say, this::confirm, this::deny, this::cancel, this::connect);
        String notLinked = context.say("Boats that are not linked");
        setName("pair-form");
        name(address, "pair-address", "Address");
        name(unpaired, "pair-unpaired", notLinked);
        name(said, "pair-words", "Words or QR code");
        name(role, "pair-role", "This base may");
        picture.setName("pair-picture");
        picture.setToolTipText(context.say("A photo or screenshot of what the boat shows: PNG, JPEG, GIF or BMP"));
        pair.setName("pair-do");
        judged.setName("pair-judged");
        offered.setName("pair-offered");
        offered.setColor(SemanticColor.MUTED);
        add(
                new WrappedText(context.say("Have the boat show its words: "
                        + switch (context.robots()) {
                            case BOAT -> "PAIR on the phone's screen, or crw boat --pair";
                            case ROBOT -> "PAIR on the phone's screen, or the program that runs its server";
                            case COPTER -> "in the program that runs its server";
                        }
                        + ". They count for five minutes.")),
                WIDE);
        row(notLinked, unpaired);
        row("Address, HOST:PORT", address);
        row("Six words, or text of the QR code", said);
        add(offered, "skip 1, growx, wmin 60");
        row("This base may", role);
        add(picture, "skip 1, split 2, grow 0, " + TALL);
        add(pair, "gapleft push, grow 0, " + TALL);
        add(judged, WIDE + ", " + TALL);
        add(check, WIDE + ", hidemode 3");
        picture.addActionListener(e -> choosePicture.run());
        pair.addActionListener(e -> pair());
        unpaired.addActionListener(e -> takeUnpaired());
        TextChanges changes = new TextChanges(this::judge);
        address.getDocument().addDocumentListener(changes);
        said.getDocument().addDocumentListener(changes);
        bind("ENTER", this, this::pair);
        bind("ctrl SPACE", said, this::complete);
        offerUnpaired();
        judge();
    }

    /** Has a picture chosen by this, which gives it to {@link #read}. */
    void choosePicture(Runnable chooser) {
        choosePicture = chooser;
    }

    private static void name(JComponent field, String name, String words) {
        field.setName(name);
        field.getAccessibleContext().setAccessibleName(words);
    }

    private void row(String title, JComponent field) {
        JLabel label = new JLabel(title);
        label.setLabelFor(field);
        if (field == unpaired) {
            label.setName("pair-unpaired-label");
        }
        add(label, "hidemode 3");
        add(field, TALL + ", wmin 60, hidemode 3");
    }

    private static void bind(String key, JComponent where, Runnable what) {
        where.getInputMap(where instanceof JTextField ? WHEN_FOCUSED : WHEN_ANCESTOR_OF_FOCUSED_COMPONENT)
                .put(KeyStroke.getKeyStroke(key), key);
        where.getActionMap().put(key, new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent pressed) {
                what.run();
            }
        });
    }

    /** Offers the addresses to which this window would link and is not linked; hidden where there are none. */
    private void offerUnpaired() {
        unpaired.addItem("");
        context.models()
                .unreached()
                .snapshot()
                .forEach(one -> unpaired.addItem(one.address() + context.say(words(one))));
        boolean any = unpaired.getItemCount() > 1;
        unpaired.setVisible(any);
        for (Component each : getComponents()) {
            if ("pair-unpaired-label".equals(each.getName())) {
                each.setVisible(any);
            }
        }
    }

    private static String words(UnreachedBoat one) {
        return (one.boat().isEmpty() ? "" : "  " + one.boat()) + (one.reason().isEmpty() ? "" : "  " + one.reason());
    }

    private void takeUnpaired() {
        String chosen = String.valueOf(unpaired.getSelectedItem());
        if (!chosen.isBlank()) {
            address.setText(chosen.split(" ", 2)[0]);
        }
    }

    /** Puts an address into the form, and the cursor behind it. */
    void begin(Optional<BoatAddress> at) {
        at.ifPresent(one -> {
            address.setText(one.toString());
            EventThread.later(said::requestFocusInWindow);
        });
    }

    private PairingDraft draft() {
        return new PairingDraft(address.getText().strip(), said.getText());
    }

    private boolean isUnderWay() {
        return attempt.filter(
                        one -> one.state() != PairingAttempt.State.FAILED && one.state() != PairingAttempt.State.PAIRED)
                .isPresent();
    }

    private void judge() {
        PairingDraft.Judgement now = draft().judge();
        boolean complete = now.state() == PairingDraft.State.COMPLETE;
        boolean wrong = now.state() == PairingDraft.State.WRONG;
        pair.setEnabled(complete && !isUnderWay());
        pair.setToolTipText(context.say(complete ? "Pair this boat (Enter)" : now.words()));
        String completions = String.join(", ", draft().completions());
        offered.setText(completions.isEmpty() ? " " : "Ctrl+Space: " + completions);
        if (!isUnderWay()) {
            say((wrong ? "▲ " : "") + now.words(), wrong ? SemanticColor.WARNING : SemanticColor.MUTED);
            check.show(Optional.empty());
        }
        fit();
    }

    /** What is typed gives way to what is asked next, so that both have room in small windows. */
    private void showEntry(boolean shown) {
        boolean offers = unpaired.getItemCount() > 1;
        for (Component part : getComponents()) {
            boolean offer = part == unpaired || "pair-unpaired-label".equals(part.getName());
            if (part != judged && part != check) {
                part.setVisible(shown && (offers || !offer));
            }
        }
    }

    private void fit() {
        revalidate();
        WindowSheet.find(this).ifPresent(WindowSheet::fit);
    }

    private void say(String text, SemanticColor color) {
        judged.setText(context.say(text));
        judged.setColor(color);
    }

    private void complete() {
        said.setText(draft().completed());
    }

    private void pair() {
        PairingDraft draft = draft();
        if (isUnderWay() || draft.judge().state() != PairingDraft.State.COMPLETE) {
            return;
        }
        PairingText text = PairingText.parse(draft.said());
        BoatPairing.Request request = new BoatPairing.Request(
                text.address(draft.address()).toSocketAddress(),
                text.words(),
                text.key(),
                role.getSelectedIndex() == 1 ? Role.OBSERVER : Role.COMMANDER,
                BaseKeys.nameOfThisBase());
        attempt = Optional.of(PairingAttempt.begin(
                request, new BaseKeys(protection.keysFolder()), EventThread.executor(), this::changed));
        changed();
    }

    private void changed() {
        attempt.ifPresent(one -> {
            SemanticColor color = switch (one.state()) {
                case FAILED -> SemanticColor.WARNING;
                case PAIRED -> SemanticColor.OK;
                default -> SemanticColor.TEXT;
            };
            String mark = switch (one.state()) {
                case FAILED -> "▲ ";
                case PAIRED -> "✓ ";
                default -> "";
            };
            boolean paired = one.state() == PairingAttempt.State.PAIRED;
            say(mark + one.words() + (paired ? plainNote() : ""), color);
            boolean free = !isUnderWay();
            pair.setEnabled(free && !paired);
            picture.setEnabled(free);
            address.setEnabled(free);
            said.setEnabled(free);
            role.setEnabled(free);
            showEntry(free && !paired);
            check.show(attempt);
            if (paired) {
                context.notices().show(one.words());
            }
            fit();
        });
    }

    /** Links to this machine are plain unless keys are named: then a key that was paired is not used. */
    private String plainNote() {
        BoatAddress at = PairingText.parse(said.getText()).address(address.getText());
        InetSocketAddress resolved = new InetSocketAddress(InetAddress.getLoopbackAddress(), at.port());
        return THIS_MACHINE.contains(at.host()) && protection.isPlain(resolved)
                ? ". Links to this machine are plain: start the window with --keys to use the key"
                : "";
    }

    private void confirm() {
        attempt.ifPresent(PairingAttempt::confirm);
    }

    private void deny() {
        attempt.ifPresent(PairingAttempt::deny);
    }

    /** Ends what is under way; also when the form is closed. */
    void cancel() {
        if (isUnderWay()) {
            attempt.ifPresent(PairingAttempt::cancel);
        }
    }

    private void connect() {
        BoatAddress at = PairingText.parse(said.getText()).address(address.getText());
        context.tell(context.session().fleet().connect(at), at + " is connected");
    }

    /** Takes the code of a picture file, which is read off the event thread. */
    void read(Path file) {
        say("Reading " + file.getFileName(), SemanticColor.TEXT);
        Thread reader = new Thread(
                () -> {
                    try {
                        String text = QrPicture.read(file);
                        EventThread.later(() -> take(text));
                    } catch (IOException fault) {
                        EventThread.later(() -> say("▲ " + fault.getMessage(), SemanticColor.WARNING));
                    }
                },
                "reading a QR code");
        reader.setDaemon(true);
        reader.start();
    }

    private void take(String text) {
        if (PairingCode.isMeant(text)) {
            address.setText("");
            said.setText(text);
            pair.requestFocusInWindow();
        } else {
            say("▲ The QR code in the picture is no pairing code of a boat", SemanticColor.WARNING);
        }
    }
}
