package org.sami.crw.gui.boat;

import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;
import net.miginfocom.swing.MigLayout;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.ui.command.Command;
import org.sami.ui.look.SemanticColor;
import org.sami.ui.value.WrappedText;

/**
 * Takes a boat's server by its address, and says what came of it: that it connects, that the boat is connected, or why not. It stays open until the
 * boat is connected or the form is closed. On the event thread.
 */
public final class ConnectForm extends JPanel {
    private static final String KEEP = "wmin 0";

    private final OperatorContext context;
    private final Runnable close;
    private final JTextField address = new JTextField(28);
    private final JButton connect = new JButton("Connect");
    private final WrappedText said = new WrappedText("");

    /**
     * An empty form.
     *
     * @param close closes what shows it
     */
    public ConnectForm(OperatorContext context, Runnable close) {
        super(new MigLayout("novisualpadding, insets 8 12 12 12, gap 8, fillx, wrap 2", "[grow,fill][]"));
        this.context = context;
        this.close = close;
        setName("boat-connect-form");
        JLabel label = new JLabel("Address of the boat's server, HOST:PORT");
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
        add(said, "span, growx, hmin 40, " + KEEP);
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
            return Optional.of("Type the address, such as 10.0.0.11:11411");
        }
        try {
            BoatAddress.parse(text);
            return Optional.empty();
        } catch (IllegalArgumentException unfit) {
            return Optional.of(unfit.getMessage());
        }
    }

    private void judge() {
        Optional<String> wrong = wrong();
        connect.setEnabled(wrong.isEmpty());
        connect.setToolTipText(wrong.orElse("Connect to this boat (Enter)"));
        say(wrong.orElse(""), SemanticColor.MUTED);
    }

    private void say(String text, SemanticColor color) {
        said.setText(text);
        said.setColor(color);
        revalidate();
    }

    private void connect() {
        Optional<String> wrong = wrong();
        if (wrong.isPresent()) {
            say("▲ " + wrong.get(), SemanticColor.WARNING);
            return;
        }
        BoatAddress at = BoatAddress.parse(address.getText().strip());
        say("Connecting to " + at + ". It goes on when this is closed.", SemanticColor.TEXT);
        context.notices().told("Connecting to " + at);
        context.session().fleet().connect(at).whenComplete((boat, fault) -> {
            if (fault == null) {
                context.notices().told(boat + " is connected");
                if (isShowing() && wasFor(at)) {
                    close.run();
                }
            } else {
                context.notices().refused(at + ": " + fault.getMessage());
                if (wasFor(at)) {
                    say("▲ " + at + ": " + fault.getMessage(), SemanticColor.WARNING);
                }
            }
        });
    }

    /** Whether the address is still the one of which something is told. */
    private boolean wasFor(BoatAddress told) {
        return wrong().isEmpty() && BoatAddress.parse(address.getText().strip()).equals(told);
    }
}
