package org.sami.ui.value;

import java.awt.Dimension;
import java.awt.Rectangle;
import javax.swing.BorderFactory;
import javax.swing.JTextArea;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.SemanticColor;

/** A text of any length that looks like a label, breaks between words, and can be copied. */
public final class WrappedText extends JTextArea {
    private static final int LEAST_WIDTH = 60;
    private SemanticColor color = SemanticColor.TEXT;
    private boolean heading;

    /** Running text. */
    public WrappedText(String text) {
        super(text);
        setEditable(false);
        setLineWrap(true);
        setWrapStyleWord(true);
        setColumns(20);
        dress();
    }

    /** The colour of the text from now on, in any theme. */
    public void setColor(SemanticColor next) {
        color = next;
        dress();
    }

    /** Whether the text is written as a heading. */
    public void setHeading(boolean heading) {
        this.heading = heading;
        dress();
    }

    private void dress() {
        setOpaque(false);
        setFocusable(false);
        setBorder(BorderFactory.createEmptyBorder());
        setFont(heading ? Fonts.heading() : Fonts.text());
        if (color != null) { // the superclass sets the look before this class has a colour
            setForeground(color.get());
        }
    }

    /** It may become narrow, and never lower than its lines are. */
    @Override
    public Dimension getMinimumSize() {
        return new Dimension(LEAST_WIDTH, getPreferredSize().height);
    }

    /** Nothing: its caret would scroll whatever it is put into to each text that is set. */
    @Override
    public void scrollRectToVisible(Rectangle region) {
        // it has no focus, so nobody is led to it
    }

    @Override
    public void updateUI() {
        super.updateUI();
        dress();
    }
}
