package org.sami.ui.map;

import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;
import org.sami.spn.value.GeoPoint;

/** Pans and zooms a map with the mouse, and gives the tool what remains: presses it wants, and clicks that were no pan. */
final class MapMouse extends MouseAdapter {
    private static final int STILL_PX = 4;

    private final MapCanvas canvas;
    private final Consumer<Optional<MapPointer>> pointed;
    private int fromX;
    private int fromY;
    private int lastX;
    private int lastY;
    private boolean panning;
    private boolean taken;

    private MapMouse(MapCanvas canvas, Consumer<Optional<MapPointer>> pointed) {
        this.canvas = canvas;
        this.pointed = pointed;
    }

    /**
     * Listens to a canvas.
     *
     * @param pointed is told where the pointer is; nowhere when it has left
     */
    static void listen(MapCanvas canvas, Consumer<Optional<MapPointer>> pointed) {
        MapMouse mouse = new MapMouse(canvas, pointed);
        canvas.addMouseListener(mouse);
        canvas.addMouseMotionListener(mouse);
        canvas.addMouseWheelListener(mouse);
    }

    private MapPointer pointer(MouseEvent e) {
        Optional<GeoPoint> snapped = canvas.tool().snaps() && !e.isAltDown()
                ? canvas.layers().snapping().at(canvas.frame(), e.getX(), e.getY())
                : Optional.empty();
        return MapPointer.of(
                e, canvas.frame(), snapped.orElseGet(() -> canvas.frame().point(e.getX(), e.getY())));
    }

    @Override
    public void mousePressed(MouseEvent e) {
        canvas.requestFocusInWindow();
        fromX = e.getX();
        fromY = e.getY();
        lastX = fromX;
        lastY = fromY;
        panning = false;
        taken = !SwingUtilities.isMiddleMouseButton(e) && canvas.tool().press(pointer(e));
    }

    @Override
    public void mouseDragged(MouseEvent e) {
        if (taken) {
            canvas.tool().drag(pointer(e));
        } else if (panning || Math.hypot(e.getX() - fromX, e.getY() - fromY) > STILL_PX) {
            panning = true;
            canvas.pan(lastX - e.getX(), lastY - e.getY());
            lastX = e.getX();
            lastY = e.getY();
        }
        pointed.accept(Optional.of(pointer(e)));
    }

    @Override
    public void mouseReleased(MouseEvent e) {
        if (taken) {
            canvas.tool().release(pointer(e));
        } else if (!panning && !SwingUtilities.isMiddleMouseButton(e)) {
            canvas.tool().click(pointer(e));
        }
        taken = false;
        panning = false;
    }

    @Override
    public void mouseMoved(MouseEvent e) {
        MapPointer pointer = pointer(e);
        canvas.tool().move(pointer);
        pointed.accept(Optional.of(pointer));
        if (canvas.tool().snaps()) {
            canvas.repaint();
        }
    }

    @Override
    public void mouseExited(MouseEvent e) {
        pointed.accept(Optional.empty());
    }

    @Override
    public void mouseWheelMoved(MouseWheelEvent e) {
        if (e.getWheelRotation() != 0) {
            canvas.zoom(-Integer.signum(e.getWheelRotation()), e.getX(), e.getY());
            pointed.accept(Optional.of(pointer(e)));
        }
    }
}
