package org.sami.crw.gui.key;

import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.sami.crw.session.key.PairingAttempt;
import org.sami.ui.look.Fonts;

/** What a pairing asks of a person while it is under way: to wait or cancel, to compare the check code, and to connect then. */
final class CheckCodePanel extends JPanel {
    private static final String TALL = "hmin 40, hidemode 3";

    private final JLabel code = new JLabel() {
        @Override
        public void updateUI() {
            super.updateUI();
            setFont(Fonts.display());
        }
    };
    private final JButton same = new JButton("The boat shows the same");
    private final JButton other = new JButton("It shows another code");
    private final JButton cancel = new JButton("Cancel");
    private final JButton connect = new JButton("Connect to the boat");
    private Optional<PairingAttempt.State> before = Optional.empty();

    CheckCodePanel(Runnable confirmed, Runnable denied, Runnable cancelled, Runnable connecting) {
        super(new MigLayout("novisualpadding, insets 0, gap 8", "[][][][]push"));
        setOpaque(false);
        code.setName("pair-code");
        code.getAccessibleContext().setAccessibleName("Check code");
        button(same, "pair-same", "Keeps the boat's key", confirmed);
        button(other, "pair-other", "Keeps nothing", denied);
        button(cancel, "pair-cancel", "Asks the boat no longer", cancelled);
        button(connect, "pair-connect", "Links this window to the boat", connecting);
        add(code, "hidemode 3, gapright 16");
        add(same, TALL);
        add(other, TALL);
        add(connect, TALL);
        add(cancel, TALL);
        setVisible(false);
    }

    private static void button(JButton button, String name, String tip, Runnable pressed) {
        button.setName(name);
        button.setToolTipText(tip);
        button.addActionListener(e -> pressed.run());
    }

    void show(Optional<PairingAttempt> attempt) {
        show(
                attempt.map(PairingAttempt::state),
                attempt.flatMap(PairingAttempt::checkCode).orElse(""));
    }

    /** Asks what a state needs; nothing for none. */
    void show(Optional<PairingAttempt.State> now, String checkCode) {
        boolean checking = now.filter(PairingAttempt.State.CHECKING::equals).isPresent();
        boolean paired = now.filter(PairingAttempt.State.PAIRED::equals).isPresent();
        boolean asking = now.filter(PairingAttempt.State.ASKING::equals).isPresent();
        code.setText(checkCode);
        code.setVisible(checking);
        same.setVisible(checking);
        other.setVisible(checking);
        connect.setVisible(paired);
        cancel.setVisible(checking || asking);
        setVisible(checking || paired || asking);
        if (!now.equals(before)) {
            before = now;
            if (checking) {
                same.requestFocusInWindow(); // by Space; Enter, which began the pairing, does nothing here
            } else if (paired) {
                connect.requestFocusInWindow();
            } else if (asking) {
                cancel.requestFocusInWindow();
            }
        }
    }
}
