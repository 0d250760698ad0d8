package org.sami.ui.net;

import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.drawing.DrawingBox;
import org.sami.spn.drawing.NetDrawing.Kind;
import org.sami.spn.drawing.NetDrawing.Label;
import org.sami.spn.drawing.NetDrawing.Vertex;
import org.sami.spn.drawing.TextBlock;
import org.sami.spn.drawing.TextStyle;
import org.sami.ui.look.SemanticColor;

/**
 * Writes the names of vertices on a net that is too small for its words, in letters that can be read: of as many as have room, what is
 * selected first, then what holds tokens, start and ends, other places, transitions.
 */
final class FarNames {
    private static final int LETTERS_PX = 12;
    private static final int MOST_TRIED = 150;
    private static final double GAP_PX = 2;

    private final Graphics2D g;
    private final double unit; // drawing units of a pixel at 100 %
    private final List<DrawingBox> taken = new ArrayList<>();

    private final DrawingBox shown;

    private FarNames(Graphics2D g, double unit, DrawingBox shown) {
        this.g = g;
        this.shown = shown;
        this.unit = unit;
    }

    /**
     * Writes names.
     *
     * @param unit how many drawing units a pixel at 100 % has
     */
    static void paint(Graphics2D g, double unit, NetScene scene, NetMarking marking, NetLight light, DrawingBox shown) {
        FarNames names = new FarNames(g, unit, shown);
        Map<String, String> texts = new HashMap<>();
        for (Label label : scene.labels()) {
            names(label).ifPresent(text -> texts.put(label.of(), text));
        }
        scene.vertices().forEach(vertex -> names.taken.add(vertex.box()));
        g.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, LETTERS_PX).deriveFont((float) (LETTERS_PX * names.unit)));
        scene.vertices().stream()
                .filter(vertex -> texts.containsKey(vertex.id()))
                .sorted(Comparator.comparingInt(vertex -> rank(vertex, marking, light)))
                .limit(MOST_TRIED)
                .forEach(vertex -> names.write(vertex, texts.get(vertex.id())));
    }

    /** The lines of a label that are a name, as one. */
    private static Optional<String> names(Label label) {
        List<String> lines = label.text().lines().stream()
                .filter(line -> line.style() == TextStyle.NAME)
                .map(TextBlock.Line::text)
                .toList();
        return lines.isEmpty() ? Optional.empty() : Optional.of(String.join(" ", lines));
    }

    private static int rank(Vertex vertex, NetMarking marking, NetLight light) {
        if (light.selected().contains(vertex.id()) || light.highlighted().contains(vertex.id())) {
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

    private void write(Vertex vertex, String text) {
        double width = NetFonts.width(text, TextStyle.EVENT) * unit;
        double height = LETTERS_PX * 1.2 * unit;
        double gap = GAP_PX * unit;
        DrawingBox at = vertex.box();
        double left = vertex.centre().x() - width / 2;
        double middle = vertex.centre().y() - height / 2;
        List<DrawingBox> boxes = List.of(
                new DrawingBox(left, at.maxY() + gap, width, height),
                new DrawingBox(left, at.y() - gap - height, width, height),
                new DrawingBox(at.maxX() + gap, middle, width, height),
                new DrawingBox(at.x() - gap - width, middle, width, height));
        boxes.stream()
                .filter(shown::contains)
                .filter(box -> taken.stream().noneMatch(box::intersects))
                .findFirst()
                .ifPresent(box -> {
                    taken.add(box.grown(gap));
                    g.setColor(SemanticColor.NET_CANVAS.withAlpha(200)); // lines are not to be read through the name
                    g.fill(new Rectangle2D.Double(box.x(), box.y(), box.width(), box.height()));
                    g.setColor(SemanticColor.TEXT.get());
                    g.drawString(text, (float) box.x(), (float) (box.y() + LETTERS_PX * 0.95 * unit));
                });
    }
}
