package org.sami.ui.net;

import edu.uci.ics.jung.visualization.VisualizationViewer;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.awt.geom.Point2D;
import java.util.Optional;
import javax.swing.SwingUtilities;
import org.sami.spn.drawing.NetDrawing.Edge;
import org.sami.spn.drawing.NetDrawing.Vertex;

/** Pans and zooms a net with the mouse, and gives the tool what remains. */
final class NetMouse implements VisualizationViewer.GraphMouse {
    private static final int STILL_PX = 4;
    private static final double REACH_PX = 5;
    private static final double STEP = 1.2;

    private final NetView view;
    private final NetViewport viewport;
    private int fromX;
    private int fromY;
    private int lastX;
    private int lastY;
    private boolean panning;
    private boolean taken;

    NetMouse(NetView view, NetViewport viewport) {
        this.view = view;
        this.viewport = viewport;
    }

    private NetPointer pointer(MouseEvent e) {
        Point2D at = viewport.point(e.getX(), e.getY());
        double reach = REACH_PX / viewport.scale();
        Optional<Vertex> vertex = view.scene().vertexAt(at.getX(), at.getY(), reach);
        Optional<Edge> edge =
                vertex.isPresent() ? Optional.empty() : view.scene().edgeAt(at.getX(), at.getY(), reach);
        return new NetPointer(
                at.getX(),
                at.getY(),
                e.getX(),
                e.getY(),
                vertex,
                edge,
                SwingUtilities.isRightMouseButton(e),
                e.isShiftDown(),
                e.isControlDown(),
                e.getClickCount());
    }

    @Override
    public void mousePressed(MouseEvent e) {
        e.getComponent().requestFocusInWindow();
        fromX = e.getX();
        fromY = e.getY();
        lastX = fromX;
        lastY = fromY;
        panning = false;
        taken = !SwingUtilities.isMiddleMouseButton(e) && view.tool().press(pointer(e));
    }

    @Override
    public void mouseDragged(MouseEvent e) {
        if (taken) {
            view.tool().drag(pointer(e));
        } else if (panning || Math.hypot(e.getX() - fromX, e.getY() - fromY) > STILL_PX) {
            panning = true;
            viewport.pan(lastX - e.getX(), lastY - e.getY());
            lastX = e.getX();
            lastY = e.getY();
        }
    }

    @Override
    public void mouseReleased(MouseEvent e) {
        if (taken) {
            view.tool().release(pointer(e));
        } else if (!panning && !SwingUtilities.isMiddleMouseButton(e)) {
            view.tool().click(pointer(e));
        }
        taken = false;
        panning = false;
    }

    @Override
    public void mouseMoved(MouseEvent e) {
        view.tool().move(pointer(e));
    }

    @Override
    public void mouseWheelMoved(MouseWheelEvent e) {
        viewport.scale(Math.pow(STEP, -e.getPreciseWheelRotation()), e.getX(), e.getY());
    }

    @Override
    public void mouseClicked(MouseEvent e) {}

    @Override
    public void mouseEntered(MouseEvent e) {}

    @Override
    public void mouseExited(MouseEvent e) {}
}
