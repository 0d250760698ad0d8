package org.sami.picture.states;

import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.OptionalInt;
import org.sami.palette.SemanticColor;
import org.sami.palette.Theme;
import org.sami.picture.Canvas;
import org.sami.picture.NetFonts;
import org.sami.picture.SvgCanvas;
import org.sami.spn.drawing.DrawingBox;
import org.sami.spn.drawing.TextBlock;
import org.sami.spn.drawing.TextStyle;
import org.sami.spn.drawing.states.StateGraph;
import org.sami.spn.drawing.states.StateGraphDrawing;
import org.sami.spn.drawing.states.StateGraphLayout;

/** The picture of a graph of states for a file, with its title and a remark, in light colours. Needs no display. */
public final class StateGraphPicture {
    private static final double MARGIN = 28;
    private static final double GAP = 22;

    private final StateGraphDrawing drawing;
    private final TextBlock title;
    private final TextBlock remark;

    private StateGraphPicture(StateGraphDrawing drawing) {
        this.drawing = drawing;
        title = TextBlock.of(List.of(drawing.graph().title()), TextStyle.TITLE, NetFonts::width);
        remark = TextBlock.of(List.of(drawing.graph().remark()), TextStyle.NOTE, NetFonts::width);
    }

    /** An SVG document of a graph, one pixel for a unit of the drawing. */
    public static String svg(StateGraph graph) {
        StateGraphPicture picture = new StateGraphPicture(StateGraphLayout.of(graph, NetFonts::width, () -> false));
        return SvgCanvas.document(graph.title(), picture.bounds(), picture::paint);
    }

    private double head() {
        return title.height() + remark.height() + GAP;
    }

    private Rectangle2D bounds() {
        DrawingBox box = drawing.bounds();
        double words = Math.max(title.width(), remark.width());
        return new Rectangle2D.Double(
                box.x() - MARGIN,
                box.y() - MARGIN - head(),
                Math.ceil(Math.max(box.width(), words) + 2 * MARGIN),
                Math.ceil(box.height() + 2 * MARGIN + head()));
    }

    private void paint(Canvas canvas) {
        canvas.fill(bounds(), SemanticColor.NET_CANVAS.in(Theme.LIGHT));
        DrawingBox box = drawing.bounds();
        double top = box.y() - head();
        line(canvas, title, SemanticColor.TEXT, box.x(), top);
        line(canvas, remark, SemanticColor.MUTED, box.x(), top + title.height());
        new StateGraphPainter(canvas, Theme.LIGHT).paint(drawing, OptionalInt.empty(), OptionalInt.empty());
    }

    private static void line(Canvas canvas, TextBlock block, SemanticColor color, double x, double y) {
        for (TextBlock.Line line : block.lines()) {
            canvas.text(
                    line.text(),
                    NetFonts.of(line.style()),
                    color.in(Theme.LIGHT),
                    x,
                    y + line.style().size());
        }
    }
}
