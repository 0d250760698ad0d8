package org.sami.ui.look;

import com.formdev.flatlaf.extras.FlatSVGIcon;
import java.awt.Color;
import javax.swing.Icon;
import org.sami.palette.SemanticColor;

/**
 * The icons: one family, drawn on 24 by 24 with lines two wide, in the colour of text. They are SVG files in {@code icons}, next to this class and
 * follow theme and scale.
 */
public final class Icons {
    private static final int SMALL = 16;
    private static final int NORMAL = 20;

    private Icons() {}

    /** An icon next to text.
     *
     * @throws IllegalArgumentException if there is none of this name
     */
    public static Icon small(String name) {
        return of(name, SMALL, SemanticColor.TEXT);
    }

    /** An icon on a button.
     *
     * @throws IllegalArgumentException if there is none of this name
     */
    public static Icon normal(String name) {
        return of(name, NORMAL, SemanticColor.TEXT);
    }

    /** An icon of a size in logical pixels, in a colour.
     *
     * @throws IllegalArgumentException if there is none of this name
     */
    public static Icon of(String name, int size, SemanticColor color) {
        FlatSVGIcon icon =
                new FlatSVGIcon("org/sami/ui/look/icons/" + name + ".svg", size, size, Icons.class.getClassLoader());
        if (!icon.hasFound()) {
            throw new IllegalArgumentException("there is no icon " + name);
        }
        icon.setColorFilter(new FlatSVGIcon.ColorFilter(drawn -> inColor(drawn, color)));
        return icon;
    }

    private static Color inColor(Color drawn, SemanticColor color) {
        return drawn.equals(Color.BLACK) ? color.get() : drawn;
    }
}
