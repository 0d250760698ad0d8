package org.sami.crw.report.picture;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Stroke;
import java.util.List;
import org.sami.crw.report.MapArea;

/**
 * The looks of boats on the map. The seven colours are those of Okabe and Ito ("Color Universal Design"), which people
 * with any of the usual colour blindnesses tell apart; yellow is left out, it vanishes on light water. From the eighth
 * boat on the same colours come back with another dash, so that 28 boats look different.
 */
public final class Palette {
    static final Color INK = new Color(0x1F2933);
    static final Color FAINT_INK = new Color(0x5F6C7B);
    static final Color WATER = new Color(0xEEF5FA);
    static final Color GRID = new Color(0xD5E1EA);
    static final Color PAPER = Color.WHITE;

    private static final List<Color> COLORS = List.of(
            new Color(0x0072B2),
            new Color(0xD55E00),
            new Color(0x009E73),
            new Color(0xCC79A7),
            new Color(0xE69F00),
            new Color(0x56B4E9),
            new Color(0x3B3B3B));
    private static final float[][] DASHES = {{}, {12, 5}, {3, 5}, {14, 5, 3, 5}};

    private Palette() {}

    /** The colour of a boat, by its place in the fleet from 0. */
    public static Color color(int boat) {
        return COLORS.get(boat % COLORS.size());
    }

    /** The rim of an area; its filling is the same, nearly transparent. */
    public static Color area(MapArea.Kind kind) {
        return switch (kind) {
            case EXPLORED -> new Color(0x56B4E9);
            case UNCOVERED -> new Color(0xE69F00);
            case AVOIDED -> new Color(0xB2182B);
            case LIMIT -> new Color(0x4D4D4D);
            case OTHER -> new Color(0x7B6FA0);
        };
    }

    /** The line of a boat's track. */
    static Stroke line(int boat) {
        return dashed(2.4f, DASHES[boat / COLORS.size() % DASHES.length]);
    }

    static Stroke dashed(float width, float... dash) {
        return dash.length == 0
                ? new BasicStroke(width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND)
                : new BasicStroke(width, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1, dash, 0);
    }

    /** Black or white, whichever reads better on a colour (relative luminance of ITU-R BT.709). */
    static Color textOn(Color background) {
        double luminance =
                0.2126 * background.getRed() + 0.7152 * background.getGreen() + 0.0722 * background.getBlue();
        return luminance > 140 ? Color.BLACK : Color.WHITE;
    }
}
