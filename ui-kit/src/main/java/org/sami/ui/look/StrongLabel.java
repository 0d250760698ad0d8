package org.sami.ui.look;

import javax.swing.JLabel;

/** A label in strong letters, which are those of the look in force at any time. */
public final class StrongLabel extends JLabel {
    /** A label with that text. */
    public StrongLabel(String text) {
        super(text);
    }

    @Override
    public void updateUI() {
        super.updateUI();
        setFont(Fonts.strong());
    }
}
