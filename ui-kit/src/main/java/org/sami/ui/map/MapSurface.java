package org.sami.ui.map;

import java.awt.event.MouseEvent;
import java.util.Optional;
import java.util.function.Consumer;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.canvas.CanvasMouse;

/** A map as the mouse has it. */
final class MapSurface implements CanvasMouse.Surface<MapPointer> {
    private final MapCanvas canvas;
    private final Consumer<Optional<MapPointer>> pointing;
    private double notches;

    /**
     * Makes the surface of a map.
     *
     * @param pointing receives the pointer's position; empty when it has left
     */
    MapSurface(MapCanvas canvas, Consumer<Optional<MapPointer>> pointing) {
        this.canvas = canvas;
        this.pointing = pointing;
    }

    @Override
    public MapTool tool() {
        return canvas.tool();
    }

    @Override
    public MapPointer pointer(MouseEvent e) {
        Optional<GeoPoint> snapped = canvas.tool().snaps() && !e.isAltDown()
                ? canvas.layers().snapping().at(canvas.frame(), e.getX(), e.getY())
                : Optional.empty();
        return MapPointer.of(
                e, canvas.frame(), snapped.orElseGet(() -> canvas.frame().point(e.getX(), e.getY())));
    }

    @Override
    public void pan(int dxPx, int dyPx) {
        canvas.pan(dxPx, dyPx);
    }

    /** By steps of two, one for a whole notch: touchpads tell small parts of one. */
    @Override
    public void zoom(double notches, int x, int y) {
        this.notches += notches;
        int steps = (int) this.notches;
        this.notches -= steps;
        if (steps != 0) {
            canvas.zoom(-steps, x, y);
        }
    }

    @Override
    public boolean isInForm() {
        return canvas.isInForm();
    }

    @Override
    public void pointed(Optional<MapPointer> pointer) {
        pointing.accept(pointer);
        if (canvas.tool().snaps()) {
            canvas.repaint();
        }
    }
}
