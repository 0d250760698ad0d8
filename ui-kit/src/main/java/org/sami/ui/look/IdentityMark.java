package org.sami.ui.look;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.util.List;

/**
 * The colour and shape that stand for one proxy in map, net and lists.
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

    /** The colour that the mark is filled with. */
    public Color color() {
        Color color = COLORS.get(index % COUNT);
        return color.equals(Color.BLACK) && Look.theme() == Theme.DARK ? Color.WHITE : color;
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

    /** Paints the mark around a point: filled, with a line that is seen on any surface. */
    public void paint(Graphics2D g, double x, double y, double diameter) {
        Graphics2D own = (Graphics2D) g.create();
        own.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        Shape outline = shape().around(x, y, diameter);
        own.setColor(color());
        own.fill(outline);
        own.setColor(SemanticColor.TEXT.get());
        own.setStroke(new BasicStroke(Look.theme() == Theme.SUN ? Look.px(2) : Math.max(1, Look.px(1))));
        own.draw(outline);
        own.dispose();
    }
}
