package org.sami.crw.report.picture;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.Stroke;
import org.sami.crw.report.MapArea;
import org.sami.palette.Contrast;
import org.sami.palette.IdentityMark;
import org.sami.palette.SemanticColor;
import org.sami.palette.Theme;

/** Colours and lines of the map: those of light windows. From the thirteenth boat on colours repeat, with another dash. */
public final class MapColors {
    static final Color INK = SemanticColor.TEXT.in(Theme.LIGHT);
    static final Color FAINT_INK = SemanticColor.MUTED.in(Theme.LIGHT);
    static final Color WATER = SemanticColor.MAP_WATER.in(Theme.LIGHT);
    static final Color GRID = SemanticColor.MAP_GRID.in(Theme.LIGHT);
    static final Color PAPER = SemanticColor.SURFACE.in(Theme.LIGHT);
    static final Color FAULT = SemanticColor.CRITICAL.in(Theme.LIGHT);

    private static final float[][] DASHES = {{}, {12, 5}, {3, 5}, {14, 5, 3, 5}};
    private static final float TRACK = 2.4f;
    private static final float CASED = 4;
    private static final double LEAST_CONTRAST = 1.6; // of a track on the water; a fainter one has dark edges

    private MapColors() {}

    /** The colour of a boat, by the index of its identity mark. */
    public static Color color(int mark) {
        return new IdentityMark(mark).color(Theme.LIGHT);
    }

    /** The rim of an area; its filling is the same, nearly transparent. */
    public static Color area(MapArea.Kind kind) {
        return switch (kind) {
            case EXPLORED, OTHER -> SemanticColor.MAP_AREA.in(Theme.LIGHT);
            case UNCOVERED -> SemanticColor.WARNING.in(Theme.LIGHT);
            case AVOIDED -> SemanticColor.MAP_NO_GO.in(Theme.LIGHT);
            case LIMIT -> SemanticColor.MAP_FENCE.in(Theme.LIGHT);
        };
    }

    /** Draws the track of a boat, by the index of its identity mark. */
    static void track(Graphics2D g, Shape line, int mark) {
        Color color = color(mark);
        float[] dash = DASHES[mark / IdentityMark.COUNT % DASHES.length];
        if (Contrast.of(color, WATER) < LEAST_CONTRAST) {
            g.setColor(FAINT_INK);
            g.setStroke(dashed(CASED, dash));
            g.draw(line);
        }
        g.setColor(color);
        g.setStroke(dashed(TRACK, dash));
        g.draw(line);
    }

    static Stroke dashed(float width, float... dash) {
        return dash.length == 0
                ? new BasicStroke(width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND)
                : new BasicStroke(width, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1, dash, 0);
    }
}
