package org.sami.picture;

import java.awt.Color;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamWriter;
import org.sami.spn.drawing.TextBlock;

/** Writes SVG elements. Each text says how wide it is, so that another font than the one that was measured takes the same room. */
final class SvgCanvas implements Canvas {
    private final XMLStreamWriter out;

    SvgCanvas(XMLStreamWriter out) {
        this.out = out;
    }

    @Override
    public void circle(Point2D centre, double radius, Color fill, Color rim, double rimWidth) {
        element(
                "circle",
                "cx",
                number(centre.getX()),
                "cy",
                number(centre.getY()),
                "r",
                number(radius),
                "fill",
                color(fill),
                "stroke",
                color(rim),
                "stroke-width",
                number(rimWidth));
    }

    @Override
    public void box(Rectangle2D box, Color fill) {
        element(
                "rect",
                "x",
                number(box.getX()),
                "y",
                number(box.getY()),
                "width",
                number(box.getWidth()),
                "height",
                number(box.getHeight()),
                "fill",
                color(fill));
    }

    @Override
    public void line(List<Point2D> points, Color color, double width, boolean dashed) {
        element(
                "polyline",
                "points",
                points(points),
                "fill",
                "none",
                "stroke",
                color(color),
                "stroke-width",
                number(width),
                "stroke-dasharray",
                dashed ? "6 5" : "none");
    }

    @Override
    public void polygon(List<Point2D> corners, Color fill) {
        element("polygon", "points", points(corners), "fill", color(fill));
    }

    @Override
    public void text(TextBlock.Line line, double x, double baseline) {
        try {
            out.writeStartElement("text");
            attributes(
                    "x",
                    number(x),
                    "y",
                    number(baseline),
                    "font-size",
                    String.valueOf(line.style().size()),
                    "font-weight",
                    line.style().isBold() ? "bold" : "normal",
                    "fill",
                    color(NetFonts.color(line.style())),
                    "textLength",
                    number(line.width()),
                    "lengthAdjust",
                    "spacingAndGlyphs");
            out.writeCharacters(XmlText.of(line.text()));
            out.writeEndElement();
            out.writeCharacters("\n");
        } catch (XMLStreamException e) {
            throw new IllegalStateException(e); // a text in memory takes everything
        }
    }

    private void element(String name, String... attributes) {
        try {
            out.writeEmptyElement(name);
            attributes(attributes);
            out.writeCharacters("\n");
        } catch (XMLStreamException e) {
            throw new IllegalStateException(e); // a text in memory takes everything
        }
    }

    private void attributes(String... attributes) throws XMLStreamException {
        for (int i = 0; i < attributes.length; i += 2) {
            out.writeAttribute(attributes[i], attributes[i + 1]);
        }
    }

    private static String points(List<Point2D> points) {
        return points.stream()
                .map(point -> number(point.getX()) + "," + number(point.getY()))
                .collect(Collectors.joining(" "));
    }

    private static String number(double value) {
        String text = String.format(Locale.ROOT, "%.1f", value);
        return text.endsWith(".0") ? text.substring(0, text.length() - 2) : text;
    }

    private static String color(Color color) {
        return String.format("#%06x", color.getRGB() & 0xFFFFFF);
    }
}
