package org.sami.crw.gui.map;

import java.awt.Color;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Insets;
import java.util.function.BooleanSupplier;
import javax.swing.border.Border;
import org.sami.palette.SemanticColor;
import org.sami.ui.look.Look;

/** The frame of the map: red while the fleet is stopped, else as quiet as what is around it. It has its width at all times, so that the map never moves. */
final class FleetStopFrame implements Border {
    private static final int WIDTH = 4;

    private final BooleanSupplier stopped;

    /** A frame that asks whether the fleet is stopped whenever it is painted. */
    FleetStopFrame(BooleanSupplier stopped) {
        this.stopped = stopped;
    }

    @Override
    public Insets getBorderInsets(Component framed) {
        int width = Look.px(WIDTH);
        return new Insets(width, width, width, width);
    }

    @Override
    public boolean isBorderOpaque() {
        return true;
    }

    @Override
    public void paintBorder(Component framed, Graphics g, int x, int y, int width, int height) {
        Color before = g.getColor();
        g.setColor((stopped.getAsBoolean() ? SemanticColor.CRITICAL_FILL : SemanticColor.SURFACE).get());
        int line = Look.px(WIDTH);
        g.fillRect(x, y, width, line);
        g.fillRect(x, y + height - line, width, line);
        g.fillRect(x, y, line, height);
        g.fillRect(x + width - line, y, line, height);
        g.setColor(before);
    }
}
