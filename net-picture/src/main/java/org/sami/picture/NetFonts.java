package org.sami.picture;

import java.awt.Color;
import java.awt.Font;
import java.awt.font.FontRenderContext;
import org.sami.spn.drawing.TextStyle;

/** What texts are written in: the font at one pixel for a drawing unit, and the colour. */
public final class NetFonts {
    private static final FontRenderContext CONTEXT = new FontRenderContext(null, true, true);

    private NetFonts() {}

    /** The font of a style, at one pixel for a drawing unit. */
    public static Font of(TextStyle style) {
        return new Font(Font.SANS_SERIF, style.isBold() ? Font.BOLD : Font.PLAIN, style.size());
    }

    /** The colour of a style. */
    public static Color color(TextStyle style) {
        return switch (style) {
            case TITLE, NAME, EVENT -> new Color(0x1F2933);
            case NOTE -> new Color(0x5F6C7B);
            case EDGE, MISSING -> new Color(0x0B5394);
        };
    }

    /** The width of a line, in drawing units. */
    public static double width(String text, TextStyle style) {
        return of(style).getStringBounds(text, CONTEXT).getWidth();
    }
}
