package org.sami.ui.value;

import javax.swing.JLabel;
import org.sami.palette.SemanticColor;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.LookColors;

/** A line of explanation next to or below a component: small, in a colour by what it means, through all changes of theme and scale. */
class NoteLabel extends JLabel {
    NoteLabel(String text) {
        super(text);
        setColor(SemanticColor.MUTED);
    }

    final void setColor(SemanticColor next) {
        LookColors.foreground(this, next);
    }

    @Override
    public void updateUI() {
        super.updateUI();
        setFont(Fonts.small());
    }
}
