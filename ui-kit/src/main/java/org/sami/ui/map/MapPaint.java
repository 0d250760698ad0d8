package org.sami.ui.map;

import java.awt.AlphaComposite;
import java.awt.Composite;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.Set;
import org.sami.palette.SemanticColor;
import org.sami.ui.geo.MapFrame;

/**
 * What a layer paints with.
 *
 * @param frame which pixels are which points
 * @param highlighted ids of what is spoken of; where there are any, everything else is dimmed
 * @param labels where something is written already
 * @param imagery whether all lies on imagery, which may be of any colour
 */
public record MapPaint(Graphics2D g, MapFrame frame, Set<String> highlighted, MapLabels labels, boolean imagery) {
    private static final float DIMMED = 0.3f;
    private static final float DIMMED_NAME = 0.7f; // still read in the sun
    private static final int PAD = 4;

    /** Paints something of that id, dimmed where other things are spoken of. */
    void paint(String id, Runnable painting) {
        paint(id, DIMMED, painting);
    }

    /** Writes the name of something of that id: where other things are spoken of it has less weight, and is still readable. */
    void name(String id, Runnable writing) {
        paint(id, DIMMED_NAME, writing);
    }

    private void paint(String id, float dimmed, Runnable painting) {
        if (!isDimmed(id)) {
            painting.run();
        } else {
            Composite before = g.getComposite();
            g.setComposite(AlphaComposite.SrcOver.derive(dimmed));
            painting.run();
            g.setComposite(before);
        }
    }

    /** Whether other things are spoken of. */
    boolean isDimmed(String id) {
        return !highlighted.isEmpty() && !highlighted.contains(id);
    }

    /** Whether somebody speaks of it, and not of everything. */
    boolean isHighlighted(String id) {
        return highlighted.contains(id);
    }

    /** The room that a text on a plate takes, its left upper corner at a pixel. */
    Rectangle2D plate(String text, double left, double top) {
        FontMetrics metrics = g.getFontMetrics();
        return new Rectangle2D.Double(left, top, metrics.stringWidth(text) + 2.0 * PAD, metrics.getHeight());
    }

    /** Writes a text on a plate of the window's background, so that it is read on any base map. */
    void write(String text, Rectangle2D plate) {
        write(text, plate, SemanticColor.TEXT);
    }

    /** The same in a colour of texts. */
    void write(String text, Rectangle2D plate, SemanticColor color) {
        g.setColor(SemanticColor.SURFACE.withAlpha(220));
        g.fillRect((int) plate.getX(), (int) plate.getY(), (int) Math.ceil(plate.getWidth()), (int)
                Math.ceil(plate.getHeight()));
        g.setColor(color.get());
        g.drawString(
                text,
                (int) plate.getX() + PAD,
                (int) plate.getY() + g.getFontMetrics().getAscent());
    }

    /**
     * Writes a name at the first of some places where it hides nothing; leaves it out where it would hide something everywhere.
     *
     * @param corners x and y of the left upper corner of each place
     */
    void writeName(String name, double... corners) {
        Rectangle2D room = plate(name, 0, 0);
        int place = labels.place(corners, room.getWidth(), room.getHeight(), 0);
        if (place >= 0) {
            Rectangle2D plate = plate(name, corners[2 * place], corners[2 * place + 1]);
            labels.addText(plate.getX(), plate.getY(), plate.getWidth(), plate.getHeight());
            write(name, plate);
        }
    }

    /** Writes from now on in the font of that style. */
    void font(int style) {
        g.setFont(g.getFont().deriveFont(style));
    }

    /** The plain style. */
    static final int PLAIN = Font.PLAIN;
}
