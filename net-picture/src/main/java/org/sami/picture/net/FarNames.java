package org.sami.picture.net;

import java.awt.Color;
import java.awt.Font;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.sami.palette.SemanticColor;
import org.sami.picture.NetFonts;
import org.sami.spn.drawing.DrawingBox;
import org.sami.spn.drawing.NetDrawing.Kind;
import org.sami.spn.drawing.NetDrawing.Label;
import org.sami.spn.drawing.NetDrawing.Vertex;
import org.sami.spn.drawing.TextBlock;
import org.sami.spn.drawing.TextStyle;

/**
 * Writes what vertices do on a net that is too small for its words, in letters that can be read: their names, or their first event's where
 * the author gave none. Whole names come first, in one line or two: of what is selected, then of what holds tokens, of start and ends, other
 * places, transitions. Names without room for all of their letters are shortened then.
 */
final class FarNames {
    private static final int LETTERS_PX = 12;
    private static final Font LETTERS = new Font(Font.SANS_SERIF, Font.PLAIN, LETTERS_PX);
    private static final int MOST_TRIED = 150;
    private static final double GAP_PX = 2;
    private static final double LINE = 1.2;
    private static final int[] SHORTENED = {14, 10, 7, 5}; // letters, with that of the omission
    private static final String DISABLED = " (disabled)";

    private final double unit; // drawing units of a pixel at 100 %
    private final DrawingBox shown;
    private final List<DrawingBox> taken = new ArrayList<>();
    private final List<Name> placed = new ArrayList<>();

    /**
     * A name on the drawing.
     *
     * @param of the vertex
     * @param lines one or two
     */
    record Name(String of, List<String> lines, DrawingBox box) {}

    private FarNames(double unit, DrawingBox shown) {
        this.shown = shown;
        this.unit = unit;
    }

    /**
     * Where which names are written.
     *
     * @param frames whose titles are not covered
     */
    static List<Name> of(NetFigure net, NetSight sight, FramePainter frames) {
        NetScene scene = net.scene();
        FarNames names = new FarNames(sight.unit(), sight.shown());
        Map<String, String> texts = new LinkedHashMap<>();
        for (Label label : scene.labels()) {
            name(label).ifPresent(text -> texts.put(label.of(), text));
        }
        scene.vertices().forEach(vertex -> names.taken.add(vertex.box()));
        names.taken.addAll(frames.titles(sight.unit()));
        List<Vertex> ranked = scene.vertices().stream()
                .filter(vertex -> texts.containsKey(vertex.id()))
                .sorted(Comparator.comparingInt(vertex -> rank(vertex, net.marking(), net.light())))
                .limit(MOST_TRIED)
                .toList();
        List<Vertex> without = new ArrayList<>();
        for (Vertex vertex : ranked) {
            String text = texts.get(vertex.id()) + (vertex.disabled() ? DISABLED : "");
            if (!names.place(vertex, List.of(text)) && !names.place(vertex, halves(text))) {
                without.add(vertex);
            }
        }
        for (Vertex vertex : without) {
            for (int letters : SHORTENED) {
                String text = shortened(Objects.requireNonNull(texts.get(vertex.id()), vertex.id()), letters);
                if (names.place(vertex, List.of(text))) {
                    break;
                }
            }
        }
        return List.copyOf(names.placed);
    }

    /** Writes names. */
    static void paint(Pen pen, NetFigure net, NetSight sight, FramePainter frames) {
        double unit = sight.unit();
        Font font = LETTERS.deriveFont((float) (LETTERS_PX * unit));
        for (Name name : of(net, sight, frames)) {
            DrawingBox box = name.box();
            pen.canvas()
                    .fill(Pen.rectangle(box), translucent(frames.below(box))); // lines must not show through the name
            double top = box.y();
            for (String line : name.lines()) {
                double left = box.x() + (box.width() - NetFonts.width(line, TextStyle.EVENT) * unit) / 2;
                pen.canvas().text(line, font, pen.color(SemanticColor.TEXT), left, top + LETTERS_PX * 0.95 * unit);
                top += LETTERS_PX * LINE * unit;
            }
        }
    }

    private static Color translucent(Color color) {
        return new Color(color.getRed(), color.getGreen(), color.getBlue(), 200);
    }

    /** What a label says of a vertex in a few words: the lines that are a name, as one, or else the first event. */
    private static Optional<String> name(Label label) {
        List<TextBlock.Line> lines = label.text().lines();
        List<String> name = lines.stream()
                .filter(line -> line.style() == TextStyle.NAME)
                .map(TextBlock.Line::text)
                .toList();
        if (!name.isEmpty()) {
            return Optional.of(String.join(" ", name));
        }
        StringBuilder event = new StringBuilder();
        for (TextBlock.Line line : lines) {
            boolean begins = line.text().startsWith("→ ") || line.text().startsWith("← ");
            if (line.style() != TextStyle.EVENT || (begins && event.length() > 0)) {
                break;
            }
            event.append(event.length() == 0 ? "" : " ")
                    .append(begins ? line.text().substring(2) : line.text());
        }
        return event.length() == 0 ? Optional.empty() : Optional.of(event.toString());
    }

    private static int rank(Vertex vertex, NetMarking marking, NetLight light) {
        if (light.isLit(vertex.id())) {
            return 0;
        }
        if (marking.isActive(vertex.id())) {
            return 1;
        }
        if (vertex.start() || vertex.end()) {
            return 2;
        }
        return vertex.kind() == Kind.PLACE ? 3 : 4;
    }

    /** A text in two lines that are about equally long; in one where it is one word. */
    private static List<String> halves(String text) {
        int middle = text.length() / 2;
        int before = text.lastIndexOf(' ', middle);
        int after = text.indexOf(' ', middle);
        int at = before < 0 || (after >= 0 && after - middle < middle - before) ? after : before;
        return at < 0 ? List.of(text) : List.of(text.substring(0, at), text.substring(at + 1));
    }

    private static String shortened(String text, int letters) {
        return text.length() <= letters ? text : text.substring(0, letters - 1).strip() + "…";
    }

    /** Places a name below its vertex, above, to the right or to the left, where nothing lies yet; says whether there was room. */
    private boolean place(Vertex vertex, List<String> lines) {
        double width = lines.stream()
                        .mapToDouble(line -> NetFonts.width(line, TextStyle.EVENT))
                        .max()
                        .orElse(0)
                * unit;
        double height = lines.size() * LETTERS_PX * LINE * unit;
        double gap = GAP_PX * unit;
        DrawingBox at = vertex.box();
        double left = vertex.centre().x() - width / 2;
        double middle = vertex.centre().y() - height / 2;
        List<DrawingBox> boxes = List.of(
                new DrawingBox(left, at.maxY() + gap, width, height),
                new DrawingBox(left, at.y() - gap - height, width, height),
                new DrawingBox(at.maxX() + gap, middle, width, height),
                new DrawingBox(at.x() - gap - width, middle, width, height));
        Optional<DrawingBox> free = boxes.stream()
                .filter(shown::contains)
                .filter(box -> taken.stream().noneMatch(box::intersects))
                .findFirst();
        free.ifPresent(box -> {
            taken.add(box.grown(gap));
            placed.add(new Name(vertex.id(), lines, box));
        });
        return free.isPresent();
    }
}
