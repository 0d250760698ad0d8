package org.sami.ui.net;

import java.awt.event.MouseEvent;
import java.awt.geom.Point2D;
import java.util.Optional;
import javax.swing.SwingUtilities;
import org.sami.spn.drawing.NetDrawing.Edge;
import org.sami.spn.drawing.NetDrawing.FrameBox;
import org.sami.spn.drawing.NetDrawing.NoteBox;
import org.sami.spn.drawing.NetDrawing.Vertex;
import org.sami.ui.canvas.CanvasMouse;

/** A net as the mouse has it. */
record NetSurface(NetView view, NetViewport viewport) implements CanvasMouse.Surface<NetPointer> {
    private static final double REACH_PX = 5;
    private static final double STEP = 1.2;

    @Override
    public NetTool tool() {
        return view.tool();
    }

    @Override
    public NetPointer pointer(MouseEvent e) {
        Point2D at = viewport.point(e.getX(), e.getY());
        double reach = REACH_PX / viewport.scale();
        Optional<Vertex> vertex = view.scene().vertexAt(at.getX(), at.getY(), reach);
        Optional<Edge> edge =
                vertex.isPresent() ? Optional.empty() : view.scene().edgeAt(at.getX(), at.getY(), reach);
        Optional<NoteBox> note = vertex.isPresent() || edge.isPresent()
                ? Optional.empty()
                : view.scene().noteAt(at.getX(), at.getY());
        Optional<FrameBox> frame = vertex.isPresent() || edge.isPresent() || note.isPresent()
                ? Optional.empty()
                : view.scene().frameAt(at.getX(), at.getY(), reach);
        return new NetPointer(
                at.getX(),
                at.getY(),
                e.getX(),
                e.getY(),
                vertex,
                edge,
                note,
                frame,
                SwingUtilities.isRightMouseButton(e),
                e.isShiftDown(),
                e.isControlDown(),
                e.getClickCount());
    }

    @Override
    public void pan(int dxPx, int dyPx) {
        viewport.pan(dxPx, dyPx);
    }

    @Override
    public void zoom(double notches, int x, int y) {
        viewport.scale(Math.pow(STEP, -notches), x, y);
    }
}
