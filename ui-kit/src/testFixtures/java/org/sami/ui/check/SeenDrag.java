package org.sami.ui.check;

import java.awt.Point;
import java.awt.dnd.DragSourceAdapter;
import java.awt.dnd.DragSourceDragEvent;
import java.awt.dnd.DragSourceDropEvent;
import java.util.Optional;

/** Where a drag was seen last, and what became of it. Receives events on the event thread; safe for use by several threads. */
final class SeenDrag extends DragSourceAdapter {
    private volatile Optional<Point> at = Optional.empty();
    private volatile boolean over;
    private volatile boolean taken;

    @Override
    public void dragEnter(DragSourceDragEvent e) {
        at = Optional.of(e.getLocation());
    }

    @Override
    public void dragOver(DragSourceDragEvent e) {
        at = Optional.of(e.getLocation());
    }

    @Override
    public void dragDropEnd(DragSourceDropEvent e) {
        taken = e.getDropSuccess();
        over = true;
    }

    boolean isAt(Point point) {
        return at.filter(seen -> Math.abs(seen.x - point.x) < 3 && Math.abs(seen.y - point.y) < 3)
                .isPresent();
    }

    boolean isOver() {
        return over;
    }

    boolean isTaken() {
        return taken;
    }
}
