package org.sami.ui.net;

import java.awt.BasicStroke;
import java.awt.Graphics2D;
import java.awt.geom.Path2D;
import org.sami.palette.SemanticColor;
import org.sami.spn.drawing.DrawingBox;
import org.sami.spn.drawing.NetDrawing.NoteBox;
import org.sami.spn.drawing.TextBlock;
import org.sami.spn.drawing.TextStyle;

/** Paints notes as sheets with a folded corner. */
final class NotePainter {
    private static final double CORNER = 11;
    private static final double ASCENT = 0.98;
    private static final BasicStroke RIM = new BasicStroke(1.2f);
    private static final BasicStroke CHOSEN = new BasicStroke(3);

    private NotePainter() {}

    /**
     * Paints a note.
     *
     * @param words whether its words can be read at this size
     */
    static void paint(Graphics2D g, NoteBox note, boolean selected, boolean words) {
        DrawingBox box = note.box();
        Path2D sheet = new Path2D.Double();
        sheet.moveTo(box.x(), box.y());
        sheet.lineTo(box.maxX() - CORNER, box.y());
        sheet.lineTo(box.maxX(), box.y() + CORNER);
        sheet.lineTo(box.maxX(), box.maxY());
        sheet.lineTo(box.x(), box.maxY());
        sheet.closePath();
        g.setColor(SemanticColor.SURFACE_RAISED.get());
        g.fill(sheet);
        g.setColor((selected ? SemanticColor.ACCENT : SemanticColor.MUTED).get());
        g.setStroke(selected ? CHOSEN : RIM);
        g.draw(sheet);
        Path2D fold = new Path2D.Double();
        fold.moveTo(box.maxX() - CORNER, box.y());
        fold.lineTo(box.maxX() - CORNER, box.y() + CORNER);
        fold.lineTo(box.maxX(), box.y() + CORNER);
        g.setStroke(RIM);
        g.draw(fold);
        if (words) {
            double top = box.y() + note.inset();
            g.setFont(NetFonts.of(TextStyle.NOTE));
            g.setColor(SemanticColor.TEXT.get());
            for (TextBlock.Line line : note.text().lines()) {
                g.drawString(line.text(), (float) (box.x() + note.inset()), (float)
                        (top + line.style().size() * ASCENT));
                top += line.height();
            }
        }
    }
}
