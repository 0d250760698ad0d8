package org.sami.architecture.sample;

import javax.swing.JDialog;
import javax.swing.JFrame;

/** Waits in a dialog, as nothing of the operator's window may. */
public final class OpensAModalDialog {
    private OpensAModalDialog() {}

    /** Opens it. */
    public static void open(JFrame owner) {
        new JDialog(owner, true).setVisible(true);
    }
}
