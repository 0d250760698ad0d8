package org.sami.ui.dock;

import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import javax.swing.Icon;
import org.sami.palette.SemanticColor;
import org.sami.ui.look.Look;

/** An icon with a dot on its upper right corner. */
record WaitingIcon(Icon plain) implements Icon {
    private static final int DOT = 9;

    @Override
    public void paintIcon(Component component, Graphics graphics, int x, int y) {
        plain.paintIcon(component, graphics, x, y);
        Graphics2D g = (Graphics2D) graphics.create();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        double size = Look.px(DOT);
        Ellipse2D dot = new Ellipse2D.Double(
                x + getIconWidth() - size - 1, y, size, size); // tabs clip what is outside of the icon
        g.setColor(SemanticColor.WARNING_FILL.get());
        g.fill(dot);
        g.setColor(SemanticColor.TEXT.get());
        g.draw(dot);
        g.dispose();
    }

    @Override
    public int getIconWidth() {
        return plain.getIconWidth();
    }

    @Override
    public int getIconHeight() {
        return plain.getIconHeight();
    }
}
