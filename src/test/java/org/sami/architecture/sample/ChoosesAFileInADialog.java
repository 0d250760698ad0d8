package org.sami.architecture.sample;

import javax.swing.JFileChooser;
import javax.swing.JFrame;

/** Has a file chosen in a dialog, as nothing of the operator's window may. */
public final class ChoosesAFileInADialog {
    private ChoosesAFileInADialog() {}

    /** Has it chosen. */
    public static int open(JFrame owner) {
        return new JFileChooser().showOpenDialog(owner);
    }
}
