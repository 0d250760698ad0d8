package org.sami.crw.gui.boat;

import java.util.Optional;
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
 * Takes a boat's server by its address, and says what came of it: which boat is connected, why it is refused, or that nobody answers, why and how often it was
 * tried. It stays open, for the next address. On the event thread.
 */
public final class ConnectForm extends JPanel {
    private static final String KEEP = "wmin 0";
    private static final int POLL_MS = 500; // how often it was tried in vain changes by itself

    private final OperatorContext context;
    private final JTextField address = new JTextField(28);
    private final JButton connect = new JButton("Connect");
    private final WrappedText said = new WrappedText("");
    private final JButton giveUp = new JButton("Give up this address");
    private final Timer look = new Timer(POLL_MS, e -> refresh());
    private Optional<ConnectAttempt> attempt = Optional.empty();

    /** An empty form. */
    public ConnectForm(OperatorContext context) {
        super(new MigLayout("novisualpadding, insets 8 12 12 12, gap 8, fillx, wrap 2", "[grow,fill][]"));
        this.context = context;
        setName("boat-connect-form");
        JLabel label = new JLabel(context.say(
                "Address: HOST:PORT of a boat's server; of vehicles mavlink:udp:14550, mavlink:tcp:HOST:PORT,"
                        + " mavlink:serial:PORT:BAUD"));
        label.setLabelFor(address);
        address.setName("boat-connect-address");
        connect.setName("boat-connect-do");
        connect.addActionListener(e -> connect());
        said.setName("boat-connect-said");
        getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT).put(KeyStroke.getKeyStroke("ENTER"), "connect");
        getActionMap().put("connect", new Command("boat-connect-enter", "Connect", this::connect));
        add(label, "span");
        add(address, "hmin 40");
        add(connect, "hmin 40");
        add(said, "growx, hmin 40, " + KEEP);
        add(giveUp, "hmin 40");
        giveUp.setName("boat-connect-give-up");
        giveUp.setToolTipText("Try this address no longer");
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
            BoatAddress.parse(text);
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
            attempt =
                    Optional.empty(); // another address is typed: what came of the last one is in messages and the list
            // of boats
        }
        refresh();
    }

    /** Says what came of the last address, or why the one that is typed cannot be used. */
    void refresh() {
        giveUp.setVisible(attempt.filter(one -> one.state() == State.NO_ANSWER).isPresent());
        if (attempt.isEmpty()) {
            say(wrong().orElse(""), SemanticColor.MUTED);
            return;
        }
        State state = attempt.get().state();
        boolean bad = state == State.REFUSED || state == State.NO_ANSWER;
        String goesOn = state == State.CONNECTING ? ". It goes on when this is closed." : "";
        say(
                (bad ? "▲ " : state == State.CONNECTED ? "✓ " : "")
                        + attempt.get().words()
                        + goesOn,
                bad ? SemanticColor.WARNING : state == State.CONNECTED ? SemanticColor.OK : SemanticColor.TEXT);
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
        BoatAddress at = BoatAddress.parse(address.getText().strip());
        address.setText("");
        attempt = Optional.of(ConnectAttempt.begin(context.session(), at, this::told));
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
        attempt.ifPresent(one -> {
            context.tell(context.session().fleet().disconnect(one.address()), one.address() + " is tried no longer");
        });
        attempt = Optional.empty();
        refresh();
        address.requestFocusInWindow();
    }
}
