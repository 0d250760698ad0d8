package org.sami.ui.canvas;

import java.awt.Component;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.util.Optional;
import javax.swing.JScrollPane;
import javax.swing.SwingUtilities;

/**
 * Pans and zooms a canvas with the mouse, and gives its tool what remains: presses it wants, and clicks that were no pan. On the event
 * thread.
 *
 * @param <P> what is known of where the pointer is
 */
public final class CanvasMouse<P> extends MouseAdapter {
    private static final int CLICK_TOLERANCE_PX = 4;

    private final Surface<P> surface;
    private int fromX;
    private int fromY;
    private int lastX;
    private int lastY;
    private boolean panning;
    private boolean taken;

    /** What is panned, zoomed and pointed at. */
    public interface Surface<P> {
        /** What has the pointer now. */
        CanvasTool<P> tool();

        /** Where an event is. */
        P pointer(MouseEvent event);

        /** Moves what is shown by some pixels. */
        void pan(int dxPx, int dyPx);

        /** Shows more of it for notches towards the person, less for those away; what is at the pixel stays there. */
        void zoom(double notches, int x, int y);

        /** Whether the wheel scrolls the form in which the canvas lies, where that can be scrolled, unless the canvas has the focus or Ctrl is held. */
        default boolean isInForm() {
            return false;
        }

        /** The pointer is elsewhere, or, with an empty one, has left. */
        default void pointed(Optional<P> pointer) {}
    }

    private CanvasMouse(Surface<P> surface) {
        this.surface = surface;
    }

    /** Listens to a component. */
    public static <P> void listen(Component component, Surface<P> surface) {
        CanvasMouse<P> mouse = new CanvasMouse<>(surface);
        component.addMouseListener(mouse);
        component.addMouseMotionListener(mouse);
        component.addMouseWheelListener(mouse);
    }

    @Override
    public void mousePressed(MouseEvent e) {
        e.getComponent().requestFocusInWindow();
        fromX = e.getX();
        fromY = e.getY();
        lastX = fromX;
        lastY = fromY;
        panning = false;
        taken = !SwingUtilities.isMiddleMouseButton(e) && surface.tool().press(surface.pointer(e));
    }

    @Override
    public void mouseDragged(MouseEvent e) {
        if (taken) {
            surface.tool().drag(surface.pointer(e));
        } else if (panning || Math.hypot(e.getX() - fromX, e.getY() - fromY) > CLICK_TOLERANCE_PX) {
            panning = true;
            surface.pan(lastX - e.getX(), lastY - e.getY());
            lastX = e.getX();
            lastY = e.getY();
        }
        surface.pointed(Optional.of(surface.pointer(e)));
    }

    @Override
    public void mouseReleased(MouseEvent e) {
        if (taken) {
            surface.tool().release(surface.pointer(e));
        } else if (!panning && !SwingUtilities.isMiddleMouseButton(e)) {
            surface.tool().click(surface.pointer(e));
        }
        taken = false;
        panning = false;
    }

    @Override
    public void mouseMoved(MouseEvent e) {
        P pointer = surface.pointer(e);
        surface.tool().move(pointer);
        surface.pointed(Optional.of(pointer));
    }

    @Override
    public void mouseExited(MouseEvent e) {
        surface.pointed(Optional.empty());
    }

    @Override
    public void mouseWheelMoved(MouseWheelEvent e) {
        Optional<JScrollPane> form = form(e);
        if (form.isPresent()) {
            form.get().dispatchEvent(SwingUtilities.convertMouseEvent(e.getComponent(), e, form.get()));
        } else if (e.getPreciseWheelRotation() != 0) {
            surface.zoom(e.getPreciseWheelRotation(), e.getX(), e.getY());
            surface.pointed(Optional.of(surface.pointer(e)));
        }
    }

    /** The form that the wheel scrolls; empty where it zooms. */
    private Optional<JScrollPane> form(MouseWheelEvent e) {
        if (!surface.isInForm() || e.isControlDown() || e.getComponent().isFocusOwner()) {
            return Optional.empty();
        }
        return Optional.ofNullable((JScrollPane) SwingUtilities.getAncestorOfClass(JScrollPane.class, e.getComponent()))
                .filter(scroll -> scroll.getVerticalScrollBar().isVisible());
    }
}
