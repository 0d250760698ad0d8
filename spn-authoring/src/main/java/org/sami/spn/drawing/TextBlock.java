package org.sami.spn.drawing;

import java.util.ArrayList;
import java.util.List;

/**
 * Some lines of text below each other, centred.
 *
 * @param lines from the top
 * @param width of the widest line, in drawing units
 */
public record TextBlock(List<Line> lines, double width) {
    private static final double LINE_HEIGHT = 1.25;

    /** One line with its width in drawing units. */
    public record Line(String text, TextStyle style, double width) {
        /** Of its line, in drawing units. */
        public double height() {
            return style.size() * LINE_HEIGHT;
        }
    }

    public TextBlock {
        lines = List.copyOf(lines);
    }

    /** Lines as they are. */
    public static TextBlock of(List<String> texts, TextStyle style, TextMeasure measure) {
        return block(texts.stream().map(text -> line(text, style, measure)).toList());
    }

    /** A heading with lines below; each is broken between words where it would be wider than {@code widest}. */
    public static TextBlock of(
            String heading,
            TextStyle headingStyle,
            List<String> texts,
            TextStyle style,
            double widest,
            TextMeasure measure) {
        List<Line> lines = new ArrayList<>(wrapped(heading, headingStyle, widest, measure));
        texts.forEach(text -> lines.addAll(wrapped(text, style, widest, measure)));
        return block(lines);
    }

    private static TextBlock block(List<Line> lines) {
        return new TextBlock(
                lines, lines.stream().mapToDouble(Line::width).max().orElse(0));
    }

    private static List<Line> wrapped(String text, TextStyle style, double widest, TextMeasure measure) {
        List<Line> lines = new ArrayList<>();
        String line = "";
        for (String word : text.isBlank() ? new String[0] : text.strip().split("\\s+", -1)) {
            String longer = line.isEmpty() ? word : line + " " + word;
            if (!line.isEmpty() && measure.width(longer, style) > widest) {
                lines.add(line(line, style, measure));
                line = word;
            } else {
                line = longer;
            }
        }
        if (!line.isEmpty()) {
            lines.add(line(line, style, measure));
        }
        return lines;
    }

    private static Line line(String text, TextStyle style, TextMeasure measure) {
        return new Line(text, style, measure.width(text, style));
    }

    /** Of all lines, in drawing units. */
    public double height() {
        return lines.stream().mapToDouble(Line::height).sum();
    }

    /** Whether nothing is written. */
    public boolean isEmpty() {
        return lines.isEmpty();
    }
}
