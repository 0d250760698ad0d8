package org.sami.picture;

import java.awt.Color;
import java.awt.geom.Rectangle2D;
import java.util.Comparator;
import java.util.List;
import org.sami.spn.drawing.DrawingBox;
import org.sami.spn.drawing.NetDrawing.FrameBox;
import org.sami.spn.drawing.TextBlock;
import org.sami.spn.model.FrameColor;

/** Paints frames behind the net, the largest first, and says which colour lies below a text. */
final class FramePainter {
    private static final double RIM = 1.5;
    private static final double ASCENT = 0.98;

    private final List<FrameBox> frames;
    private final Color paper;

    FramePainter(List<FrameBox> frames, Color paper) {
        this.frames = frames.stream()
                .sorted(Comparator.comparingDouble((FrameBox frame) -> -frame.width() * frame.height()))
                .toList();
        this.paper = paper;
    }

    /** Paints them, moved by so much. */
    void paint(Canvas canvas, double dx, double dy) {
        for (FrameBox frame : frames) {
            DrawingBox box = frame.box();
            canvas.box(moved(box, dx, dy), rim(frame.color()));
            canvas.box(moved(box.grown(-RIM), dx, dy), fill(frame.color()));
            double top = frame.titleBox().y() + dy;
            for (TextBlock.Line line : frame.title().lines()) {
                canvas.text(line, frame.titleBox().x() + dx, top + line.style().size() * ASCENT);
                top += line.height();
            }
        }
    }

    private static Rectangle2D moved(DrawingBox box, double dx, double dy) {
        return new Rectangle2D.Double(box.x() + dx, box.y() + dy, box.width(), box.height());
    }

    /** The colour on which a text lies: that of the smallest frame that holds its middle, or the paper's. */
    Color below(DrawingBox text) {
        Color below = paper;
        for (FrameBox frame : frames) {
            if (frame.box().contains(text.x() + text.width() / 2, text.y() + text.height() / 2)) {
                below = fill(frame.color());
            }
        }
        return below;
    }

    private static Color rim(FrameColor color) {
        return switch (color) {
            case BLUE -> new Color(0x5B8DBE);
            case TEAL -> new Color(0x3F9C95);
            case VIOLET -> new Color(0x8A78C2);
            case PINK -> new Color(0xBE78A4);
            case SAND -> new Color(0xA68F4E);
            case GREY -> new Color(0x87919B);
        };
    }

    private static Color fill(FrameColor color) {
        return switch (color) {
            case BLUE -> new Color(0xEAF2FA);
            case TEAL -> new Color(0xE6F5F3);
            case VIOLET -> new Color(0xF1EEFA);
            case PINK -> new Color(0xFAEDF5);
            case SAND -> new Color(0xF8F3E2);
            case GREY -> new Color(0xF1F3F5);
        };
    }
}
