package org.sami.ui.value;

import javax.swing.JLabel;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.SemanticColor;

/** A line beside or below something that says more of it: small, in a colour by what it means, through all changes of theme and scale. */
class NoteLabel extends JLabel {
    private SemanticColor color = SemanticColor.MUTED;

    NoteLabel(String text) {
        super(text);
        dress();
    }

    final void setColor(SemanticColor next) {
        color = next;
        dress();
    }

    private void dress() {
        setFont(Fonts.small());
        if (color != null) { // the superclass sets the look before this class has a colour
            setForeground(color.get());
        }
    }

    @Override
    public void updateUI() {
        super.updateUI();
        dress();
    }
}
