package org.sami.picture.net;

import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.List;
import javax.imageio.ImageIO;
import org.sami.palette.ProxyMarks;
import org.sami.palette.SemanticColor;
import org.sami.palette.Theme;
import org.sami.picture.Canvas;
import org.sami.picture.GraphicsCanvas;
import org.sami.picture.NetFonts;
import org.sami.picture.SvgCanvas;
import org.sami.spn.drawing.DrawingBox;
import org.sami.spn.drawing.NetDrawing;
import org.sami.spn.drawing.NetLayout;
import org.sami.spn.drawing.TextBlock;
import org.sami.spn.drawing.TextStyle;
import org.sami.spn.model.Plan;
import org.sami.spn.vocabulary.Vocabulary;

/** The picture of a plan's net for a file, with its title, in the colours of light windows. Drawn in memory; needs no display. */
public final class NetPicture {
    private static final double SHARPNESS = 2; // pixels of a PNG for one drawing unit
    private static final double MOST_PIXELS = 100e6;
    private static final double MARGIN = 32;
    private static final double HEAD = 58;
    private static final double INSET = 8; // of the title into the margin
    private static final String KEY =
            "≥ 1 Generic and Take 1 Generic of one transition are not written; dashed lines have no condition.";

    private final NetDrawing drawing;
    private final TextBlock title;
    private final TextBlock key;

    /** The picture of a drawing; its texts were measured by {@link NetFonts#width}. */
    public NetPicture(NetDrawing drawing) {
        this(drawing, KEY);
    }

    /** @param key a line that says what the words and lines mean */
    public NetPicture(NetDrawing drawing, String key) {
        this.drawing = drawing;
        this.key = TextBlock.of(List.of(key), TextStyle.NOTE, NetFonts::width);
        title = TextBlock.of(List.of(drawing.title()), TextStyle.TITLE, NetFonts::width);
    }

    /**
     * Draws a plan as its author has laid it out, or else in layers.
     *
     * @param plan a plan that was read without errors
     * @param anew draw it in layers although it has a layout
     */
    public static NetPicture of(Plan plan, Vocabulary vocabulary, boolean anew) {
        return new NetPicture(
                anew
                        ? NetLayout.layered(plan, vocabulary, NetFonts::width)
                        : NetLayout.given(plan, vocabulary, NetFonts::width));
    }

    /** The picture's area, in drawing units: pixels at scale 1. Its sides are whole, its corner is wherever the drawing begins. */
    public Rectangle2D bounds() {
        DrawingBox net = drawing.bounds();
        double words = Math.max(title.width(), key.width());
        return new Rectangle2D.Double(
                net.x() - MARGIN,
                net.y() - MARGIN - HEAD,
                Math.ceil(Math.max(net.width(), words) + 2 * MARGIN),
                Math.ceil(net.height() + 2 * MARGIN + HEAD));
    }

    /** Paints it, where {@link #bounds} says. */
    public void paint(Canvas canvas) {
        Pen pen = new Pen(canvas, Theme.LIGHT);
        DrawingBox net = drawing.bounds();
        double top = net.y() - HEAD - INSET;
        pen.fill(bounds(), SemanticColor.NET_CANVAS);
        pen.text(title, SemanticColor.TEXT, net.x(), top, false);
        pen.text(key, SemanticColor.MUTED, net.x(), top + title.height() + 2, false);
        NetFigure all = NetFigure.of(NetScene.of(drawing));
        NetPainter.paint(canvas, pen.theme(), new ProxyMarks(), all, new NetSight(net, 1, 1));
    }

    /** Where everything lies. */
    public NetDrawing drawing() {
        return drawing;
    }

    /** An SVG document. */
    public String svg() {
        return SvgCanvas.document(drawing.title(), bounds(), this::paint);
    }

    /** A PNG, two pixels for one unit of the drawing where that is not too large a picture. */
    public byte[] png() throws IOException {
        Rectangle2D bounds = bounds();
        double scale = Math.min(SHARPNESS, Math.sqrt(MOST_PIXELS / (bounds.getWidth() * bounds.getHeight())));
        BufferedImage image = new BufferedImage(
                (int) Math.ceil(bounds.getWidth() * scale),
                (int) Math.ceil(bounds.getHeight() * scale),
                BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        try {
            g.scale(scale, scale);
            g.translate(-bounds.getX(), -bounds.getY());
            paint(new GraphicsCanvas(g));
        } finally {
            g.dispose();
        }
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        ImageIO.write(image, "png", bytes);
        return bytes.toByteArray();
    }
}
