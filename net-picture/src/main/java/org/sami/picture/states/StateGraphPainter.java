package org.sami.picture.states;

import java.awt.BasicStroke;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RoundRectangle2D;
import java.util.List;
import java.util.OptionalInt;
import org.sami.palette.SemanticColor;
import org.sami.palette.Theme;
import org.sami.picture.Canvas;
import org.sami.picture.NetFonts;
import org.sami.spn.drawing.DrawingBox;
import org.sami.spn.drawing.TextBlock;
import org.sami.spn.drawing.states.StateGraph;
import org.sami.spn.drawing.states.StateGraphDrawing;
import org.sami.spn.model.LayoutPoint;

/** Paints a graph of states: the initial state with a green rim, ends with a double one, deadlocks red and with their word, states that were not followed dashed. */
public final class StateGraphPainter {
    private static final double CORNER = 12;
    private static final double INSET = 7; // as the layout leaves it around the words
    private static final double ASCENT = 0.98; // of a letter's size, from the top of its line to its base line
    private static final double ARROW_LENGTH = 8;
    private static final double ARROW_HALF_WIDTH = 3.2;
    private static final double DOUBLE = 3;
    private static final BasicStroke THIN = new BasicStroke(1.2f);
    private static final BasicStroke THICK = new BasicStroke(2.4f);
    private static final BasicStroke DASHED =
            new BasicStroke(1.2f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 4, new float[] {5, 4}, 0);

    private final Canvas canvas;
    private final Theme theme;

    public StateGraphPainter(Canvas canvas, Theme theme) {
        this.canvas = canvas;
        this.theme = theme;
    }

    /**
     * Paints a graph.
     *
     * @param state that is highlighted, if any
     * @param arrow that is highlighted, if any
     */
    public void paint(StateGraphDrawing drawing, OptionalInt state, OptionalInt arrow) {
        for (int i = 0; i < drawing.lines().size(); i++) {
            line(drawing.lines().get(i), arrow.isPresent() && arrow.getAsInt() == i);
        }
        for (int i = 0; i < drawing.boxes().size(); i++) {
            StateGraph.Kind kind = drawing.graph().states().get(i).kind();
            box(drawing.boxes().get(i), kind, i == 0, state.isPresent() && state.getAsInt() == i);
        }
    }

    private void line(StateGraphDrawing.Line line, boolean isSelected) {
        SemanticColor color = isSelected ? SemanticColor.NET_FIRING : SemanticColor.NET_EDGE;
        List<LayoutPoint> points = line.points();
        Path2D path = new Path2D.Double();
        path.moveTo(points.get(0).x(), points.get(0).y());
        points.stream().skip(1).forEach(point -> path.lineTo(point.x(), point.y()));
        canvas.draw(path, color.in(theme), isSelected ? THICK : THIN);
        head(points.get(points.size() - 2), points.get(points.size() - 1), color);
        if (!line.text().isEmpty()) {
            DrawingBox label = line.label();
            canvas.fill(
                    new Rectangle2D.Double(label.x() - 1, label.y(), label.width() + 2, label.height()),
                    SemanticColor.NET_CANVAS.in(theme));
            text(line.text(), isSelected ? color : SemanticColor.TEXT, label.x(), label.y());
        }
    }

    private void head(LayoutPoint from, LayoutPoint to, SemanticColor color) {
        double length = Math.hypot(to.x() - from.x(), to.y() - from.y());
        if (length == 0) {
            return;
        }
        double ux = (to.x() - from.x()) / length;
        double uy = (to.y() - from.y()) / length;
        double backX = to.x() - ux * ARROW_LENGTH;
        double backY = to.y() - uy * ARROW_LENGTH;
        Path2D head = new Path2D.Double();
        head.moveTo(to.x(), to.y());
        head.lineTo(backX - uy * ARROW_HALF_WIDTH, backY + ux * ARROW_HALF_WIDTH);
        head.lineTo(backX + uy * ARROW_HALF_WIDTH, backY - ux * ARROW_HALF_WIDTH);
        head.closePath();
        canvas.fill(head, color.in(theme));
    }

    private void box(StateGraphDrawing.Box box, StateGraph.Kind kind, boolean isInitial, boolean isSelected) {
        DrawingBox area = box.area();
        SemanticColor rim = rim(kind, isInitial);
        canvas.fillAndDraw(
                rounded(area),
                (isSelected ? SemanticColor.SELECTION : SemanticColor.NET_PLACE_FILL).in(theme),
                (isSelected ? SemanticColor.ACCENT : rim).in(theme),
                isSelected || isInitial ? THICK : kind == StateGraph.Kind.NOT_FOLLOWED ? DASHED : THIN);
        if (kind == StateGraph.Kind.END) {
            canvas.draw(rounded(area.grown(-DOUBLE)), rim.in(theme), THIN);
        }
        SemanticColor words = isSelected
                ? SemanticColor.ON_SELECTION
                : kind == StateGraph.Kind.DEADLOCK ? SemanticColor.CRITICAL : SemanticColor.TEXT;
        text(box.text(), words, area.x() + INSET, area.y() + INSET);
    }

    private static SemanticColor rim(StateGraph.Kind kind, boolean isInitial) {
        return switch (kind) {
            case DEADLOCK -> SemanticColor.CRITICAL;
            case END -> SemanticColor.NET_END;
            case INNER, NOT_FOLLOWED -> isInitial ? SemanticColor.NET_START : SemanticColor.NET_PLACE;
        };
    }

    private static RoundRectangle2D rounded(DrawingBox box) {
        return new RoundRectangle2D.Double(box.x(), box.y(), box.width(), box.height(), CORNER, CORNER);
    }

    /** Writes lines below each other, each in the middle of the block. */
    private void text(TextBlock block, SemanticColor color, double x, double y) {
        double top = y;
        for (TextBlock.Line line : block.lines()) {
            double left = x + (block.width() - line.width()) / 2;
            canvas.text(
                    line.text(),
                    NetFonts.of(line.style()),
                    color.in(theme),
                    left,
                    top + line.style().size() * ASCENT);
            top += line.height();
        }
    }
}
