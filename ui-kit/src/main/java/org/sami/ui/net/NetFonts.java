package org.sami.ui.net;

import java.awt.Font;
import java.awt.font.FontRenderContext;
import java.util.EnumMap;
import java.util.Map;
import org.sami.spn.drawing.TextStyle;

/** The fonts of a net, at one pixel for a drawing unit, and how wide texts are in them at any zoom. */
final class NetFonts {
    private static final FontRenderContext CONTEXT = new FontRenderContext(null, true, true);
    private static final Map<TextStyle, Font> FONTS = fonts();

    private NetFonts() {}

    private static Map<TextStyle, Font> fonts() {
        Map<TextStyle, Font> fonts = new EnumMap<>(TextStyle.class);
        for (TextStyle style : TextStyle.values()) {
            fonts.put(style, new Font(Font.SANS_SERIF, style.isBold() ? Font.BOLD : Font.PLAIN, style.size()));
        }
        return fonts;
    }

    static Font of(TextStyle style) {
        return FONTS.get(style);
    }

    static double width(String text, TextStyle style) {
        return of(style).getStringBounds(text, CONTEXT).getWidth();
    }
}
