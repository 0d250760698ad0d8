package org.sami.architecture.sample;

import javax.swing.JFrame;
import javax.swing.JOptionPane;

/** Asks in a dialog of Swing's, as nothing of the operator's window may. */
public final class AsksInAnOptionPane {
    private AsksInAnOptionPane() {}

    /** Asks. */
    public static String ask(JFrame owner) {
        return JOptionPane.showInputDialog(owner, "?");
    }
}
