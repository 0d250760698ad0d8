package org.sami.picture;

import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.StringWriter;
import javax.imageio.ImageIO;
import javax.xml.stream.XMLOutputFactory;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamWriter;
import org.sami.spn.drawing.NetDrawing;
import org.sami.spn.drawing.NetLayout;
import org.sami.spn.model.Plan;
import org.sami.spn.vocabulary.Vocabulary;

/** The picture of a plan's net. Drawn in memory; needs no display. */
public final class NetPicture {
    private static final double SHARPNESS = 2; // pixels of a PNG for one drawing unit
    private static final double MOST_PIXELS = 100e6;

    private final NetDrawing drawing;
    private final NetPainter painter;

    /** The picture of a drawing; its texts were measured by {@link NetFonts#width}. */
    public NetPicture(NetDrawing drawing) {
        this.drawing = drawing;
        painter = new NetPainter(drawing);
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

    /** Its width, in pixels at scale 1. */
    public double width() {
        return painter.width();
    }

    /** Its height. */
    public double height() {
        return painter.height();
    }

    /** Paints it. */
    public void paint(Canvas canvas) {
        painter.paint(canvas);
    }

    /** Where everything lies. */
    public NetDrawing drawing() {
        return drawing;
    }

    /** An SVG document. */
    public String svg() {
        StringWriter text = new StringWriter();
        try {
            XMLStreamWriter out = XMLOutputFactory.newInstance().createXMLStreamWriter(text);
            out.writeStartDocument("UTF-8", "1.0");
            out.writeCharacters("\n");
            out.writeStartElement("svg");
            out.writeDefaultNamespace("http://www.w3.org/2000/svg");
            String width = String.valueOf((int) painter.width());
            String height = String.valueOf((int) painter.height());
            out.writeAttribute("width", width);
            out.writeAttribute("height", height);
            out.writeAttribute("viewBox", "0 0 " + width + " " + height);
            out.writeAttribute("font-family", "sans-serif");
            out.writeCharacters("\n");
            out.writeStartElement("title");
            out.writeCharacters(XmlText.of(drawing.title()));
            out.writeEndElement();
            out.writeCharacters("\n");
            painter.paint(new SvgCanvas(out));
            out.writeEndElement();
            out.writeEndDocument();
        } catch (XMLStreamException e) {
            throw new IllegalStateException(e); // a text in memory takes everything
        }
        return text.append('\n').toString();
    }

    /** A PNG, two pixels for one unit of the drawing where that is not too large a picture. */
    public byte[] png() throws IOException {
        double scale = Math.min(SHARPNESS, Math.sqrt(MOST_PIXELS / (painter.width() * painter.height())));
        BufferedImage image = new BufferedImage(
                (int) Math.ceil(painter.width() * scale),
                (int) Math.ceil(painter.height() * scale),
                BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        try {
            g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
            g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
            g.setRenderingHint(RenderingHints.KEY_FRACTIONALMETRICS, RenderingHints.VALUE_FRACTIONALMETRICS_ON);
            g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
            g.scale(scale, scale);
            painter.paint(new PngCanvas(g));
        } finally {
            g.dispose();
        }
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        ImageIO.write(image, "png", bytes);
        return bytes.toByteArray();
    }
}
