package org.sami.ui.net;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.event.MouseEvent;
import java.awt.geom.AffineTransform;
import java.util.function.BiConsumer;
import java.util.function.Function;
import javax.swing.JPanel;
import org.sami.palette.SemanticColor;
import org.sami.ui.look.FocusFrame;

/** The component on which a net is painted; {@link NetViewport} moves what it shows. */
final class NetViewer extends JPanel {
    private static final Dimension PREFERRED = new Dimension(600, 400);

    private final transient BiConsumer<Graphics2D, Double> painting;
    private final transient Function<MouseEvent, String> tips;
    private final AffineTransform view = new AffineTransform();

    /**
     * Makes a viewer of an empty net.
     *
     * @param painting paints with a graphics in drawing units, and so many pixels for one
     * @param tips the tooltip of the element under the pointer; null for none
     */
    NetViewer(BiConsumer<Graphics2D, Double> painting, Function<MouseEvent, String> tips) {
        this.painting = painting;
        this.tips = tips;
        setName("net-canvas");
        setOpaque(true);
        setFocusable(true);
        FocusFrame.watch(this);
        setPreferredSize(PREFERRED);
        setToolTipText("");
    }

    /** From drawing units to pixels; whoever changes it repaints. */
    AffineTransform view() {
        return view;
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        graphics.setColor(getBackground());
        graphics.fillRect(0, 0, getWidth(), getHeight());
        Graphics2D g = (Graphics2D) graphics.create(0, 0, getWidth(), getHeight()); // its clip is what is seen
        g.transform(view);
        painting.accept(g, g.getTransform().getScaleX());
        g.dispose();
        FocusFrame.paint(graphics, this);
    }

    /** Asked at each painting, so that another theme is seen at once. */
    @Override
    public Color getBackground() {
        return SemanticColor.NET_CANVAS.get();
    }

    @Override
    public String getToolTipText(MouseEvent event) {
        return tips.apply(event);
    }
}
