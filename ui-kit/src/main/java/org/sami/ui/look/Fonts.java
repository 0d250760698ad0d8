package org.sami.ui.look;

import java.awt.Font;
import java.awt.font.TextAttribute;
import java.util.Map;

/** The type of windows: the platform's sans in four sizes, at the scale in force. Its figures are of one width on all platforms. */
public final class Fonts {
    private static final int TEXT = 13;
    private static final int HEADING = 15;
    private static final int TITLE = 18;
    private static final int DISPLAY = 24;
    private static final int SMALL = 12;

    private Fonts() {}

    /** Running text, 13 px. */
    public static Font text() {
        return sans(Font.PLAIN, TEXT);
    }

    /** Running text that is to be seen first. */
    public static Font strong() {
        return sans(Font.BOLD, TEXT);
    }

    /** Secondary text next to running text, 12 px: no text is smaller at 100 %. */
    public static Font small() {
        return sans(Font.PLAIN, SMALL);
    }

    /** The head of a panel or group, 15 px. */
    public static Font heading() {
        return sans(Font.BOLD, HEADING);
    }

    /** The one thing that a panel is about, 18 px. */
    public static Font title() {
        return sans(Font.BOLD, TITLE);
    }

    /** What is read from across the table, 24 px. */
    public static Font display() {
        return sans(Font.BOLD, DISPLAY);
    }

    /** Text to be compared letter by letter, such as addresses. */
    public static Font monospaced() {
        return new Font(Font.MONOSPACED, Font.PLAIN, TEXT).deriveFont(scaled(TEXT));
    }

    /** The font that a look scales by itself. */
    static Font base() {
        return new Font(Font.SANS_SERIF, Font.PLAIN, TEXT);
    }

    private static Font sans(int style, int size) {
        return new Font(Font.SANS_SERIF, style, size)
                .deriveFont(Map.of(TextAttribute.SIZE, scaled(size), TextAttribute.KERNING, TextAttribute.KERNING_ON));
    }

    private static float scaled(int size) {
        return size * LookScale.percent() / 100f;
    }
}
