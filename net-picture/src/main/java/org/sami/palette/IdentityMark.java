package org.sami.palette;

import java.awt.Color;
import java.util.List;

/**
 * The colour and shape that stand for one proxy in map, net, lists and reports.
 *
 * @param index in order of appearance, from 0
 */
public record IdentityMark(int index) {
    /**
     * Told apart with deuteranopia and in print: Okabe and Ito (2008) but for black, which the last place has, then four that lie between.
     * Black is white where the theme is dark.
     */
    private static final List<Color> COLORS = List.of(
            new Color(0xE69F00),
            new Color(0x56B4E9),
            new Color(0x009E73),
            new Color(0xF0E442),
            new Color(0x0072B2),
            new Color(0xD55E00),
            new Color(0xCC79A7),
            new Color(0x882255),
            new Color(0x999933),
            new Color(0x6A5ACD),
            new Color(0x8C5A2B),
            Color.BLACK);

    /** How many colours there are before they repeat with another shape. */
    public static final int COUNT = 12;

    public IdentityMark {
        if (index < 0) {
            throw new IllegalArgumentException("an identity mark is counted from 0, not " + index);
        }
    }

    /** The colour that the mark is filled with in the theme in force. */
    public Color color() {
        return color(Theme.inForce());
    }

    /** The colour that the mark is filled with in a theme. */
    public Color color(Theme theme) {
        Color color = COLORS.get(index % COUNT);
        return color.equals(Color.BLACK) && theme == Theme.DARK ? Color.WHITE : color;
    }

    /** The colour of words on the mark. */
    public Color ink() {
        return Contrast.inkOn(color());
    }

    /** The shape that the mark has. */
    public MarkShape shape() {
        MarkShape[] shapes = MarkShape.values();
        return shapes[index / COUNT % shapes.length];
    }
}
