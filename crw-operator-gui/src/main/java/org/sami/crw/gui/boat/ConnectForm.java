package org.sami.crw.gui.boat;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.Timer;
import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;
import net.miginfocom.swing.MigLayout;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.session.ConnectAttempt;
import org.sami.crw.session.ConnectAttempt.State;
import org.sami.palette.SemanticColor;
import org.sami.ui.command.Command;
import org.sami.ui.value.WrappedText;

/**
 * Takes boats by their addresses, as {@code --connect} does: several with commas between them, and several vehicles of one link. Says what came of each: which boat
 * is connected, why it is refused, or that nobody answers, why and how often it was tried. It stays open, for the next address. On the event thread.
 */
public final class ConnectForm extends JPanel {
    private static final String KEEP = "wmin 0";
    private static final int POLL_MS = 500; // how often it was tried in vain changes by itself

    private final OperatorContext context;
    private final JTextField address = new JTextField(28);
    private final JButton connect = new JButton("Connect");
    private final WrappedText said = new WrappedText("");
    private final JButton giveUp = new JButton("Give up what does not answer");
    private final Timer look = new Timer(POLL_MS, e -> refresh());
    private List<ConnectAttempt> attempts = List.of();

    /** An empty form. */
    public ConnectForm(OperatorContext context) {
        super(new MigLayout("novisualpadding, insets 8 12 12 12, gap 8, fillx, wrap 2", "[grow,fill][]"));
        this.context = context;
        setName("boat-connect-form");
        JLabel label = new JLabel("Address");
        WrappedText forms = new WrappedText(
                context.say("HOST:PORT of a boat's server; of vehicles mavlink:udp:14550, mavlink:tcp:HOST:PORT,"
                        + " mavlink:udpout:HOST:PORT, mavlink:serial:DEVICE:BAUD, and after it /3 for the one of system"
                        + " id 3, /1-5 for five; several with commas between them"));
        forms.setName("boat-connect-forms");
        forms.setColor(SemanticColor.MUTED);
        label.setLabelFor(address);
        address.setName("boat-connect-address");
        address.setToolTipText("A radio behind a network's port has its speed after it: mavlink:udp:14550?baud=57600");
        connect.setName("boat-connect-do");
        connect.addActionListener(e -> connect());
        said.setName("boat-connect-said");
        getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT).put(KeyStroke.getKeyStroke("ENTER"), "connect");
        getActionMap().put("connect", new Command("boat-connect-enter", "Connect", this::connect));
        add(label, "span");
        add(forms, "span, growx, " + KEEP);
        add(address, "hmin 40");
        add(connect, "hmin 40");
        add(said, "growx, hmin 40, " + KEEP);
        add(giveUp, "hmin 40");
        giveUp.setName("boat-connect-give-up");
        giveUp.setToolTipText("Try the addresses at which nobody answers no longer");
        giveUp.addActionListener(e -> giveUp());
        addHierarchyListener(event -> {
            if (isShowing()) {
                look.start();
            } else {
                look.stop();
            }
        });
        address.getDocument().addDocumentListener(new DocumentListener() {
            @Override
            public void insertUpdate(DocumentEvent e) {
                judge();
            }

            @Override
            public void removeUpdate(DocumentEvent e) {
                judge();
            }

            @Override
            public void changedUpdate(DocumentEvent e) {
                judge();
            }
        });
        judge();
    }

    /** Why the address cannot be used; empty where it can. */
    private Optional<String> wrong() {
        String text = address.getText().strip();
        if (text.isEmpty()) {
            return Optional.of("Type the address, such as 10.0.0.11:11411 or mavlink:udp:14550");
        }
        try {
            BoatAddress.parseAll(text);
            return Optional.empty();
        } catch (IllegalArgumentException unfit) {
            return Optional.of(String.valueOf(unfit.getMessage()));
        }
    }

    private void judge() {
        Optional<String> wrong = wrong();
        connect.setEnabled(wrong.isEmpty());
        connect.setToolTipText(context.say(wrong.orElse("Connect to this boat (Enter)")));
        if (!address.getText().isBlank()) {
            attempts =
                    List.of(); // another address is typed: what came of the last is in messages and the list of boats
        }
        refresh();
    }

    /** Says what came of the last addresses, or why what is typed cannot be used. */
    void refresh() {
        giveUp.setVisible(attempts.stream().anyMatch(one -> one.state() == State.NO_ANSWER));
        if (attempts.isEmpty()) {
            say(wrong().orElse(""), SemanticColor.MUTED);
            return;
        }
        boolean isBad = attempts.stream().anyMatch(ConnectForm::isBad);
        boolean isDone = attempts.stream().allMatch(one -> one.state() == State.CONNECTED);
        say(
                attempts.stream().map(ConnectForm::words).collect(Collectors.joining("\n")),
                isBad ? SemanticColor.WARNING : isDone ? SemanticColor.OK : SemanticColor.TEXT);
    }

    private static boolean isBad(ConnectAttempt one) {
        return one.state() == State.REFUSED || one.state() == State.NO_ANSWER;
    }

    private static String words(ConnectAttempt one) {
        String mark = isBad(one) ? "▲ " : one.state() == State.CONNECTED ? "✓ " : "";
        return mark + one.words() + (one.state() == State.CONNECTING ? ". It goes on when this is closed." : "");
    }

    private void say(String given, SemanticColor color) {
        String text = context.say(given);
        if (!said.getText().equals(text)) {
            said.setText(text);
            revalidate();
        }
        said.setColor(color);
    }

    private void connect() {
        Optional<String> wrong = wrong();
        if (wrong.isPresent()) {
            say("▲ " + wrong.get(), SemanticColor.WARNING);
            return;
        }
        List<BoatAddress> all = BoatAddress.parseAll(address.getText().strip());
        address.setText("");
        attempts = all.stream()
                .map(at -> ConnectAttempt.begin(context.session(), at, this::told))
                .toList();
        refresh();
    }

    /** A boat answered, or the address is refused: also shown at the top, because this form may be closed by then. */
    private void told(ConnectAttempt one) {
        if (one.state() == State.REFUSED) {
            context.notices().refused(one.words());
        } else {
            context.notices().show(one.words());
        }
        refresh();
    }

    private void giveUp() {
        attempts.stream()
                .filter(one -> one.state() == State.NO_ANSWER)
                .forEach(one -> context.tell(
                        context.session().fleet().disconnect(one.address()), one.address() + " is tried no longer"));
        attempts =
                attempts.stream().filter(one -> one.state() != State.NO_ANSWER).toList();
        refresh();
        address.requestFocusInWindow();
    }
}
