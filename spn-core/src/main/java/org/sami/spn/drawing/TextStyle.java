package org.sami.crw.sim.drawing;

import java.awt.Color;
import java.awt.Font;
import java.awt.font.FontRenderContext;

/** The kinds of text on a drawing. */
public enum TextStyle {
    /** The plan's name. */
    TITLE(Font.BOLD, 22, new Color(0x1F2933)),
    /** What is said about the whole drawing. */
    NOTE(Font.PLAIN, 13, new Color(0x5F6C7B)),
    /** A vertex's name. */
    NAME(Font.BOLD, 13, new Color(0x1F2933)),
    /** Events and sub-missions. */
    EVENT(Font.PLAIN, 12, new Color(0x1F2933)),
    /** Requirements. */
    EDGE(Font.PLAIN, 12, new Color(0x0B5394));

    private static final FontRenderContext CONTEXT = new FontRenderContext(null, true, true);

    private final int style;
    private final int size;
    private final Color color;

    TextStyle(int style, int size, Color color) {
        this.style = style;
        this.size = size;
        this.color = color;
    }

    /** The height of its letters, in drawing units. */
    public int size() {
        return size;
    }

    /** Whether it is bold. */
    public boolean isBold() {
        return style == Font.BOLD;
    }

    /** What it is written in. */
    public Color color() {
        return color;
    }

    /** The font, at one pixel for a drawing unit. */
    public Font font() {
        return new Font(Font.SANS_SERIF, style, size);
    }

    /** The width of a line, in drawing units. */
    public double width(String text) {
        return font().getStringBounds(text, CONTEXT).getWidth();
    }
}
