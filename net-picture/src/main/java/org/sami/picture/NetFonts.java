package org.sami.picture;

import java.awt.Font;
import java.awt.font.FontRenderContext;
import java.util.EnumMap;
import java.util.Map;
import java.util.Objects;
import org.sami.spn.drawing.TextStyle;

/** The fonts of a net, at one pixel for a drawing unit, and how wide texts are in them: the same at any zoom, in windows and in files. */
public final class NetFonts {
    /** Texts are measured without a screen, with soft rims and fractions of a pixel. */
    public static final FontRenderContext CONTEXT = new FontRenderContext(null, true, true);

    private static final Map<TextStyle, Font> FONTS = fonts();

    private NetFonts() {}

    private static Map<TextStyle, Font> fonts() {
        Map<TextStyle, Font> fonts = new EnumMap<>(TextStyle.class);
        for (TextStyle style : TextStyle.values()) {
            fonts.put(style, new Font(Font.SANS_SERIF, style.isBold() ? Font.BOLD : Font.PLAIN, style.size()));
        }
        return fonts;
    }

    /** The font of a style. */
    public static Font of(TextStyle style) {
        return Objects.requireNonNull(FONTS.get(style), style.name());
    }

    /** The width of a line, in drawing units. */
    public static double width(String text, TextStyle style) {
        return width(text, of(style));
    }

    /** The width of a line in a font. */
    public static double width(String text, Font font) {
        return font.getStringBounds(text, CONTEXT).getWidth();
    }
}
