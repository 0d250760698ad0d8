package org.sami.ui.net;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import org.sami.palette.SemanticColor;
import org.sami.spn.drawing.DrawingBox;

/** Paints a whole net into a picture, in the colours of the theme in force. */
final class NetSnapshot {
    private static final double MARGIN = 24;
    private static final double MOST_PIXELS = 50e6;

    private NetSnapshot() {}

    /**
     * The picture of a scene.
     *
     * @param bounds of all that is shown, in drawing units
     * @param scale pixels of a drawing unit; less where the picture would be too large for the memory
     */
    static BufferedImage of(NetPainter painter, DrawingBox bounds, NetScene scene, NetMarking marking, double scale) {
        DrawingBox all = bounds.grown(MARGIN);
        double bounded = Math.min(scale, Math.sqrt(MOST_PIXELS / (all.width() * all.height())));
        BufferedImage image = new BufferedImage(
                Math.max(1, (int) Math.ceil(all.width() * bounded)),
                Math.max(1, (int) Math.ceil(all.height() * bounded)),
                BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.setColor(SemanticColor.NET_CANVAS.get());
        g.fillRect(0, 0, image.getWidth(), image.getHeight());
        g.scale(bounded, bounded);
        g.translate(-all.x(), -all.y());
        painter.paint(g, bounded, 1, scene, marking, NetLight.NONE);
        g.dispose();
        return image;
    }
}
