package org.sami.crw.gui.key;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.Timer;
import net.miginfocom.swing.MigLayout;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.proxy.key.BaseKeys;
import org.sami.crw.proxy.phone.OwnNetwork;
import org.sami.crw.proxy.tcp.BaseProtection;
import org.sami.crw.session.key.PairingAttempt;
import org.sami.crw.session.key.PhoneInvitation;
import org.sami.palette.SemanticColor;
import org.sami.ui.EventThread;
import org.sami.ui.sheet.WindowSheet;
import org.sami.ui.value.WrappedText;

/**
 * The code with which phones fetch the app and are paired: the network in which they are, the QR code, and the check code of a phone that has come. What it offers
 * ends with it. On the event thread; networks are listed, and all else is done, off it.
 */
final class PhoneForm extends JPanel {
    private static final String TALL = "hmin 40";
    private static final int LOOK_MS = 1000;
    private static final String STEPS = """
        1. Have the phone join the network above.
        2. Scan this code with its camera, and open the page.
        3. Install the app from the page; then press Open the app and pair.
        4. Compare the six digits.\
        """;

    private final OperatorContext context;
    private final JLabel networkLabel = new JLabel("Network of the phone");
    private final JComboBox<OwnNetwork> networks = new JComboBox<>();
    private final WrappedText app = new WrappedText("");
    private final CodePicture code = new CodePicture("phone-code", "QR code for a phone");
    private final WrappedText steps = new WrappedText(STEPS);
    private final WrappedText said = new WrappedText("Looking for networks");
    private final CheckCodePanel check;
    private final Timer look = new Timer(LOOK_MS, e -> refresh());
    private Optional<PhoneInvitation> invitation = Optional.empty();
    private boolean closed;

    PhoneForm(OperatorContext context) {
        super(new MigLayout(
                "novisualpadding, insets 8 12 12 12, gap 8, fillx, wrap 2, hidemode 3, w 660::", "[][grow,fill]"));
        this.context = context;
        check = new CheckCodePanel(context::say, this::confirm, this::deny, this::deny, () -> {});
        setName("phone-form");
        networks.setName("phone-network");
        networkLabel.setLabelFor(networks);
        app.setName("phone-app");
        app.setColor(SemanticColor.MUTED);
        said.setName("phone-said");
        add(networkLabel);
        add(networks, TALL + ", wmin 60");
        add(code, "grow 0, aligny top, shrinky 100");
        add(steps, "aligny top, wmin 60");
        add(said, "span, growx, wmin 60");
        add(check, "span, growx, wmin 60");
        add(app, "span, growx, wmin 60");
        networks.addActionListener(e -> begin());
        Thread lister = new Thread(this::listNetworks, "networks of this computer");
        lister.setDaemon(true);
        lister.start();
        look.start();
    }

    private void listNetworks() {
        try {
            List<OwnNetwork> all = OwnNetwork.all();
            EventThread.later(() -> offer(all));
        } catch (IOException fault) {
            EventThread.later(
                    () -> say("▲ The networks cannot be listed: " + fault.getMessage(), SemanticColor.WARNING));
        }
    }

    private void offer(List<OwnNetwork> all) {
        all.forEach(networks::addItem); // the first one is chosen with that
        networks.requestFocusInWindow();
        if (all.isEmpty()) {
            say(
                    "▲ This computer is in no network: join that of the phones, and open this again",
                    SemanticColor.WARNING);
        }
    }

    private void begin() {
        invitation.ifPresent(PhoneInvitation::close);
        invitation = Optional.empty();
        if (!closed && networks.getSelectedItem() instanceof OwnNetwork network) {
            invitation = Optional.of(PhoneInvitation.begin(
                    network.address(),
                    new BaseKeys(BaseProtection.ofThisProcess().keysFolder()),
                    EventThread.executor(),
                    this::changed));
        }
    }

    private void refresh() {
        invitation.flatMap(PhoneInvitation::code).ifPresent(code::show);
    }

    private void changed() {
        invitation.ifPresent(now -> {
            boolean checks = now.state() == PhoneInvitation.State.CHECKING;
            boolean done = now.hasPaired();
            say(
                    (now.isBad() ? "▲ " : done ? "✓ " : "") + now.words(),
                    now.isBad() ? SemanticColor.WARNING : done ? SemanticColor.OK : SemanticColor.TEXT);
            app.setText(now.appWords());
            app.setColor(now.hasApp() ? SemanticColor.MUTED : SemanticColor.WARNING);
            networks.setEnabled(!checks);
            showCode(!checks && now.state() != PhoneInvitation.State.KEEPING);
            refresh();
            check.show(
                    checks ? Optional.of(PairingAttempt.State.CHECKING) : Optional.empty(),
                    now.checkCode().orElse(""));
            if (done) {
                context.notices().show(now.words());
            }
            revalidate();
            WindowSheet.find(this).ifPresent(WindowSheet::fit);
        });
    }

    /** Hides the QR code while the check code is shown, so that both fit into small windows. */
    private void showCode(boolean shown) {
        code.setVisible(shown);
        steps.setVisible(shown);
        networks.setVisible(shown);
        networkLabel.setVisible(shown);
        app.setVisible(shown);
    }

    private void say(String text, SemanticColor color) {
        said.setText(text);
        said.setColor(color);
    }

    private void confirm() {
        invitation.ifPresent(PhoneInvitation::confirm);
    }

    private void deny() {
        invitation.ifPresent(PhoneInvitation::deny);
    }

    /** Ends what is offered. */
    void close() {
        closed = true;
        look.stop();
        invitation.ifPresent(PhoneInvitation::close);
        invitation = Optional.empty();
    }
}
