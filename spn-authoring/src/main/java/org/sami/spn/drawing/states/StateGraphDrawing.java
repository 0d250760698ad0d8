package org.sami.spn.drawing.states;

import java.util.List;
import java.util.OptionalInt;
import java.util.stream.IntStream;
import org.sami.spn.drawing.DrawingBox;
import org.sami.spn.drawing.TextBlock;
import org.sami.spn.model.LayoutPoint;

/**
 * Where the parts of a graph lie, in drawing units, y downwards. Immutable.
 *
 * @param boxes one for each state
 * @param lines one for each arrow
 * @param bounds around all of them
 */
public record StateGraphDrawing(StateGraph graph, List<Box> boxes, List<Line> lines, DrawingBox bounds) {
    /** How near to a line a point touches it, in drawing units. */
    private static final double TOUCH = 5;

    /** A state with its words. */
    public record Box(DrawingBox area, TextBlock text) {}

    /**
     * An arrow with its words.
     *
     * @param points from the rim of one box to that of the other
     * @param label of the words' left upper corner; its size is that of the words
     */
    public record Line(List<LayoutPoint> points, TextBlock text, DrawingBox label) {
        public Line {
            points = List.copyOf(points);
        }
    }

    public StateGraphDrawing {
        boxes = List.copyOf(boxes);
        lines = List.copyOf(lines);
    }

    /** The state whose box a point lies in; empty where it lies in none. */
    public OptionalInt stateAt(double x, double y) {
        return IntStream.range(0, boxes.size())
                .filter(i -> boxes.get(i).area().contains(x, y))
                .findFirst();
    }

    /** The arrow whose words or line are at a point; empty where there is none. */
    public OptionalInt arrowAt(double x, double y) {
        OptionalInt labelled = IntStream.range(0, lines.size())
                .filter(i ->
                        !lines.get(i).text().isEmpty() && lines.get(i).label().contains(x, y))
                .findFirst();
        DrawingBox near = new DrawingBox(x, y, 0, 0).grown(TOUCH);
        return labelled.isPresent()
                ? labelled
                : IntStream.range(0, lines.size())
                        .filter(i -> isTouched(lines.get(i).points(), near))
                        .findFirst();
    }

    private static boolean isTouched(List<LayoutPoint> points, DrawingBox near) {
        return IntStream.range(1, points.size()).anyMatch(i -> near.isCrossedBy(points.get(i - 1), points.get(i)));
    }
}
