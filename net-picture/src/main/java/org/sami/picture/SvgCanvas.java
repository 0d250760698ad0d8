package org.sami.picture;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.PathIterator;
import java.awt.geom.Rectangle2D;
import java.io.StringWriter;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import javax.xml.stream.XMLOutputFactory;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamWriter;

/** Writes SVG elements. Each text says how wide it is, so that another font than the one that was measured takes the same room. */
public final class SvgCanvas implements Canvas {
    private static final String[] COMMANDS = {"M", "L", "Q", "C", "Z"}; // by the constants of PathIterator
    private static final int[] NUMBERS = {2, 2, 4, 6, 0};

    private final XMLStreamWriter out;

    private SvgCanvas(XMLStreamWriter out) {
        this.out = out;
    }

    /**
     * An SVG document.
     *
     * @param area that is shown, in the picture's units, of which one is a pixel
     * @param painting paints all that is in it
     */
    public static String document(String title, Rectangle2D area, Consumer<Canvas> painting) {
        StringWriter text = new StringWriter();
        try {
            XMLStreamWriter out = XMLOutputFactory.newInstance().createXMLStreamWriter(text);
            SvgCanvas canvas = new SvgCanvas(out);
            out.writeStartDocument("UTF-8", "1.0");
            out.writeCharacters("\n");
            out.writeStartElement("svg");
            out.writeDefaultNamespace("http://www.w3.org/2000/svg");
            String size = number(area.getWidth()) + " " + number(area.getHeight());
            canvas.attributes(
                    List.of("width", number(area.getWidth()), "height", number(area.getHeight())),
                    List.of("viewBox", number(area.getX()) + " " + number(area.getY()) + " " + size),
                    List.of("font-family", "sans-serif"));
            out.writeCharacters("\n");
            out.writeStartElement("title");
            out.writeCharacters(XmlText.of(title));
            out.writeEndElement();
            out.writeCharacters("\n");
            painting.accept(canvas);
            out.writeEndElement();
            out.writeEndDocument();
        } catch (XMLStreamException e) {
            throw new IllegalStateException(e); // a text in memory takes everything
        }
        return text.append('\n').toString();
    }

    @Override
    public void fill(Shape shape, Color color) {
        element(shape, paint("fill", color), List.of());
    }

    @Override
    public void draw(Shape shape, Color color, BasicStroke stroke) {
        element(shape, List.of("fill", "none"), line(color, stroke));
    }

    @Override
    public void fillAndDraw(Shape shape, Color fill, Color rim, BasicStroke stroke) {
        element(shape, paint("fill", fill), line(rim, stroke));
    }

    @Override
    public void text(String text, Font font, Color color, double x, double baseline) {
        try {
            out.writeStartElement("text");
            attributes(
                    List.of("x", number(x), "y", number(baseline), "font-size", number(font.getSize2D())),
                    List.of("font-weight", font.isBold() ? "bold" : "normal"),
                    paint("fill", color),
                    List.of("textLength", number(NetFonts.width(text, font)), "lengthAdjust", "spacingAndGlyphs"));
            out.writeCharacters(XmlText.of(text));
            out.writeEndElement();
            out.writeCharacters("\n");
        } catch (XMLStreamException e) {
            throw new IllegalStateException(e); // a text in memory takes everything
        }
    }

    private void element(Shape shape, List<String> fill, List<String> line) {
        try {
            if (shape instanceof Ellipse2D circle && circle.getWidth() == circle.getHeight()) {
                out.writeEmptyElement("circle");
                String radius = number(circle.getWidth() / 2);
                attributes(List.of("cx", number(circle.getCenterX()), "cy", number(circle.getCenterY()), "r", radius));
            } else if (shape instanceof Rectangle2D box) {
                out.writeEmptyElement("rect");
                attributes(
                        List.of("x", number(box.getX()), "y", number(box.getY())),
                        List.of("width", number(box.getWidth()), "height", number(box.getHeight())));
            } else {
                out.writeEmptyElement("path");
                attributes(List.of("d", path(shape)));
            }
            attributes(fill, line);
            out.writeCharacters("\n");
        } catch (XMLStreamException e) {
            throw new IllegalStateException(e); // a text in memory takes everything
        }
    }

    private static String path(Shape shape) {
        StringBuilder path = new StringBuilder();
        double[] points = new double[6];
        for (PathIterator i = shape.getPathIterator(null); !i.isDone(); i.next()) {
            int command = i.currentSegment(points);
            path.append(path.length() == 0 ? "" : " ").append(COMMANDS[command]);
            path.append(Arrays.stream(points, 0, NUMBERS[command])
                    .mapToObj(SvgCanvas::number)
                    .collect(Collectors.joining(" ")));
        }
        return path.toString();
    }

    /** Attributes that say which colour, and how opaque where it is not. */
    private static List<String> paint(String name, Color color) {
        List<String> attributes = new ArrayList<>(List.of(name, String.format("#%06x", color.getRGB() & 0xFFFFFF)));
        if (color.getAlpha() < 255) {
            attributes.addAll(List.of(name + "-opacity", String.format(Locale.ROOT, "%.2f", color.getAlpha() / 255.0)));
        }
        return attributes;
    }

    private static List<String> line(Color color, BasicStroke stroke) {
        List<String> attributes = paint("stroke", color);
        attributes.addAll(List.of("stroke-width", number(stroke.getLineWidth())));
        float[] dash = stroke.getDashArray();
        if (dash != null) {
            String lengths = IntStream.range(0, dash.length)
                    .mapToObj(i -> number(dash[i]))
                    .collect(Collectors.joining(" "));
            attributes.addAll(List.of("stroke-dasharray", lengths));
        }
        return attributes;
    }

    @SafeVarargs
    private void attributes(List<String>... named) throws XMLStreamException {
        for (List<String> attributes : named) {
            for (int i = 0; i < attributes.size(); i += 2) {
                out.writeAttribute(attributes.get(i), attributes.get(i + 1));
            }
        }
    }

    private static String number(double value) {
        String text = String.format(Locale.ROOT, "%.1f", value);
        return text.endsWith(".0") ? text.substring(0, text.length() - 2) : text;
    }
}
