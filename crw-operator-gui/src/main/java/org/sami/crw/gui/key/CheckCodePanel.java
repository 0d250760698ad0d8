package org.sami.crw.gui.key;

import java.util.Optional;
import java.util.function.UnaryOperator;
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
    private final JButton same;
    private final JButton other = new JButton("It shows another code");
    private final JButton cancel = new JButton("Cancel");
    private final JButton connect;
    private Optional<PairingAttempt.State> before = Optional.empty();

    /** @param words puts the word for the session's robots into a text about boats */
    CheckCodePanel(
            UnaryOperator<String> words, Runnable confirmed, Runnable denied, Runnable cancelled, Runnable connecting) {
        super(new MigLayout("novisualpadding, insets 0, gap 8", "[][][][]push"));
        same = new JButton(words.apply("The boat shows the same"));
        connect = new JButton(words.apply("Connect to the boat"));
        setOpaque(false);
        code.setName("pair-code");
        code.getAccessibleContext().setAccessibleName("Check code");
        button(same, "pair-same", words.apply("Keeps the boat's key"), confirmed);
        button(other, "pair-other", "Keeps nothing", denied);
        button(cancel, "pair-cancel", words.apply("Asks the boat no longer"), cancelled);
        button(connect, "pair-connect", words.apply("Links this window to the boat"), connecting);
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
