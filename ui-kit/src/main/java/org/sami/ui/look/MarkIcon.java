package org.sami.ui.look;

import java.awt.BasicStroke;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.Shape;
import javax.swing.Icon;
import org.sami.palette.IdentityMark;
import org.sami.palette.SemanticColor;
import org.sami.palette.Theme;

/** A proxy's mark as an icon, next to its name. */
public final class MarkIcon implements Icon {
    private static final int SIZE = 14;
    private final IdentityMark mark;

    /** An icon of this mark. */
    public MarkIcon(IdentityMark mark) {
        this.mark = mark;
    }

    @Override
    public void paintIcon(Component c, Graphics g, int x, int y) {
        double size = getIconWidth();
        paint((Graphics2D) g, mark, x + size / 2, y + size / 2, size - Look.px(3));
    }

    /** Paints a mark around a point: filled, with a line that is seen on any surface. */
    public static void paint(Graphics2D g, IdentityMark mark, double x, double y, double diameter) {
        Graphics2D own = (Graphics2D) g.create();
        own.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        Shape outline = mark.shape().around(x, y, diameter);
        own.setColor(mark.color());
        own.fill(outline);
        own.setColor(SemanticColor.TEXT.get());
        own.setStroke(new BasicStroke(Look.theme() == Theme.SUN ? Look.px(2) : Math.max(1, Look.px(1))));
        own.draw(outline);
        own.dispose();
    }

    @Override
    public int getIconWidth() {
        return Look.px(SIZE);
    }

    @Override
    public int getIconHeight() {
        return Look.px(SIZE);
    }
}
