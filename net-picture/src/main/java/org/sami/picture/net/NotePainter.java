package org.sami.picture.net;

import java.awt.BasicStroke;
import java.awt.geom.Path2D;
import org.sami.palette.SemanticColor;
import org.sami.spn.drawing.DrawingBox;
import org.sami.spn.drawing.NetDrawing.NoteBox;

/** Paints notes as sheets with a folded corner. */
final class NotePainter {
    private static final double CORNER = 11;
    private static final BasicStroke RIM = new BasicStroke(1.2f);
    private static final BasicStroke CHOSEN = new BasicStroke(3);

    private NotePainter() {}

    /**
     * Paints a note.
     *
     * @param words whether its words can be read at this size
     */
    static void paint(Pen pen, NoteBox note, boolean selected, boolean words) {
        DrawingBox box = note.box();
        Path2D sheet = new Path2D.Double();
        sheet.moveTo(box.x(), box.y());
        sheet.lineTo(box.maxX() - CORNER, box.y());
        sheet.lineTo(box.maxX(), box.y() + CORNER);
        sheet.lineTo(box.maxX(), box.maxY());
        sheet.lineTo(box.x(), box.maxY());
        sheet.closePath();
        SemanticColor rim = selected ? SemanticColor.ACCENT : SemanticColor.MUTED;
        pen.fillAndDraw(sheet, SemanticColor.SURFACE_RAISED, rim, selected ? CHOSEN : RIM);
        Path2D fold = new Path2D.Double();
        fold.moveTo(box.maxX() - CORNER, box.y());
        fold.lineTo(box.maxX() - CORNER, box.y() + CORNER);
        fold.lineTo(box.maxX(), box.y() + CORNER);
        pen.draw(fold, rim, RIM);
        if (words) {
            pen.text(note.text(), SemanticColor.TEXT, box.x() + note.inset(), box.y() + note.inset(), false);
        }
    }
}
