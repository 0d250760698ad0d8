package org.sami.picture.net;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.geom.RoundRectangle2D;
import java.util.Comparator;
import java.util.List;
import java.util.Set;
import org.sami.palette.SemanticColor;
import org.sami.palette.Theme;
import org.sami.picture.NetFonts;
import org.sami.spn.drawing.DrawingBox;
import org.sami.spn.drawing.NetDrawing.FrameBox;
import org.sami.spn.drawing.TextBlock;
import org.sami.spn.model.FrameColor;

/** Paints frames behind a net, the largest first, and says which colour lies below a text. */
final class FramePainter {
    private static final double ASCENT = 0.98;
    private static final double TINT = 0.12;
    private static final double CORNER = 10;
    private static final double HANDLE_SIZE = 10;
    private static final BasicStroke RIM = new BasicStroke(1.4f);
    private static final BasicStroke CHOSEN = new BasicStroke(3);

    private final List<FrameBox> frames;
    private final Theme theme;

    FramePainter(List<FrameBox> frames, Theme theme) {
        this.theme = theme;
        this.frames = frames.stream()
                .sorted(Comparator.comparingDouble((FrameBox frame) -> -frame.width() * frame.height()))
                .toList();
    }

    /**
     * Paints them.
     *
     * @param letters how many times larger than its own size a title is written, so that it is read from afar as well; as far as the frame is
     *     wide enough
     */
    void paint(Pen pen, Set<String> selected, double letters) {
        for (FrameBox frame : frames) {
            boolean chosen = selected.contains(NetScene.idOfFrame(frame.index()));
            DrawingBox box = frame.box();
            RoundRectangle2D shape =
                    new RoundRectangle2D.Double(box.x(), box.y(), box.width(), box.height(), CORNER, CORNER);
            SemanticColor rim = chosen ? SemanticColor.ACCENT : color(frame.color());
            pen.canvas().fillAndDraw(shape, tint(frame.color()), pen.color(rim), chosen ? CHOSEN : RIM);
            if (chosen) {
                pen.fill(
                        new RoundRectangle2D.Double(
                                box.maxX() - HANDLE_SIZE, box.maxY() - HANDLE_SIZE, HANDLE_SIZE, HANDLE_SIZE, 3, 3),
                        rim);
            }
            title(pen, frame, letters(frame, letters));
        }
    }

    private static double letters(FrameBox frame, double wanted) {
        double room = frame.width() - 2 * (frame.titleBox().x() - frame.x());
        return Math.max(1, Math.min(wanted, room / Math.max(1, frame.title().width())));
    }

    /** Where titles are written. */
    List<DrawingBox> titles(double letters) {
        return frames.stream()
                .map(frame -> {
                    DrawingBox at = frame.titleBox();
                    double larger = letters(frame, letters);
                    return new DrawingBox(at.x(), at.y(), at.width() * larger, at.height() * larger);
                })
                .toList();
    }

    private static void title(Pen pen, FrameBox frame, double letters) {
        DrawingBox at = frame.titleBox();
        double top = at.y();
        for (TextBlock.Line line : frame.title().lines()) {
            double size = line.style().size() * letters;
            Font font = NetFonts.of(line.style()).deriveFont((float) size);
            pen.canvas().text(line.text(), font, pen.color(SemanticColor.TEXT), at.x(), top + size * ASCENT);
            top += line.height() * letters;
        }
    }

    /** The colour on which a text lies: that of the smallest frame that holds its middle, or the canvas's. */
    Color below(DrawingBox text) {
        Color below = SemanticColor.NET_CANVAS.in(theme);
        for (FrameBox frame : frames) {
            if (frame.box().contains(text.x() + text.width() / 2, text.y() + text.height() / 2)) {
                below = tint(frame.color());
            }
        }
        return below;
    }

    private Color tint(FrameColor color) {
        return color(color).over(SemanticColor.NET_CANVAS, TINT, theme);
    }

    private static SemanticColor color(FrameColor color) {
        return switch (color) {
            case BLUE -> SemanticColor.NET_FRAME_BLUE;
            case TEAL -> SemanticColor.NET_FRAME_TEAL;
            case VIOLET -> SemanticColor.NET_FRAME_VIOLET;
            case PINK -> SemanticColor.NET_FRAME_PINK;
            case SAND -> SemanticColor.NET_FRAME_SAND;
            case GREY -> SemanticColor.NET_FRAME_GREY;
        };
    }
}
