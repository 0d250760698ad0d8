package org.sami.ui.value;

import java.awt.Dimension;
import java.awt.Font;
import java.awt.Insets;
import java.awt.Rectangle;
import java.awt.font.FontRenderContext;
import java.util.function.Supplier;
import java.util.regex.Pattern;
import javax.swing.BorderFactory;
import javax.swing.JTextArea;
import org.jspecify.annotations.Nullable;
import org.sami.palette.SemanticColor;
import org.sami.ui.EventThread;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.LookColors;

/** A text of any length that looks like a label, breaks between words but not between a number and its unit, and can be copied. */
public final class WrappedText extends JTextArea {
    private static final int LEAST_WIDTH = 60;
    private static final char NO_BREAK = '\u00a0';
    private static final Pattern BEFORE_UNIT =
            Pattern.compile("(?<=\\d) (?=(?:%|°|mm|m|km|m²|km²|m/s|ms|s|min|h|Hz)(?![\\p{L}\\p{N}]))");

    private final transient Supplier<Font> letters;
    private transient @Nullable Measured measured; // none before the size was first asked for
    private transient Dimension needed = new Dimension();

    /** What the size of a text depends on, but for the look. */
    private record Measured(String text, Font font, FontRenderContext rendering, int width, int columns) {}

    /** Running text. */
    public WrappedText(String text) {
        this(text, Fonts::text);
    }

    private WrappedText(String text, Supplier<Font> letters) {
        super(text);
        this.letters = letters;
        setEditable(false);
        setLineWrap(true);
        setWrapStyleWord(true);
        setColumns(20);
        setColor(SemanticColor.TEXT);
        setBorder(BorderFactory.createEmptyBorder());
        dress();
    }

    /** A text that is written as a heading. */
    public static WrappedText heading(String text) {
        return new WrappedText(text, Fonts::heading);
    }

    /** A text in strong letters. */
    public static WrappedText strong(String text) {
        return new WrappedText(text, Fonts::strong);
    }

    @Override
    public void setText(String text) {
        super.setText(text == null ? null : BEFORE_UNIT.matcher(text).replaceAll(String.valueOf(NO_BREAK)));
    }

    /** The text as it was set. */
    @Override
    public String getText() {
        return super.getText().replace(NO_BREAK, ' ');
    }

    @Override
    public @Nullable String getSelectedText() {
        String selected = super.getSelectedText();
        return selected == null ? null : selected.replace(NO_BREAK, ' ');
    }

    /** The colour of the text from now on, in any theme. */
    public void setColor(SemanticColor next) {
        LookColors.foreground(this, next);
    }

    private void dress() {
        setOpaque(false);
        setFocusable(false);
        if (letters != null) { // the superclass sets the look before this class has its letters
            setFont(letters.get());
        }
    }

    /** Kept while nothing changes that it depends on: to break lines each letter is measured, and a layout asks several times. */
    @Override
    public Dimension getPreferredSize() {
        Insets insets = getInsets();
        if (getWidth() <= insets.left + insets.right + 1 || getHeight() <= insets.top + insets.bottom) {
            return super.getPreferredSize(); // at no width of its own
        }
        Measured now = new Measured(
                super.getText(),
                getFont(),
                getFontMetrics(getFont()).getFontRenderContext(),
                getWidth() - insets.left - insets.right,
                getColumns());
        if (!now.equals(measured)) {
            needed = super.getPreferredSize();
            measured = now;
        }
        return new Dimension(needed);
    }

    /** Where it has become too narrow for its lines, it asks for more height once the layout that made it so has ended: that one knew another width. */
    @Override
    public void setBounds(int x, int y, int width, int height) {
        boolean other = width != getWidth();
        super.setBounds(x, y, width, height);
        if (other && width > 0 && height > 0 && getPreferredSize().height > height) {
            EventThread.later(this::revalidate);
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
        measured = null;
    }
}
