package org.sami.ui.map;

import java.awt.event.MouseEvent;
import javax.swing.SwingUtilities;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.geo.MapFrame;

/**
 * Where the pointer is on a map.
 *
 * @param at the point there, or that it snaps to
 * @param menu whether it asks for a menu: the right button
 * @param box whether a box is meant: Shift is held
 */
record MapPointer(
        MapFrame frame, double px, double py, GeoPoint at, boolean menu, boolean box, boolean additive, int clicks) {
    static MapPointer of(MouseEvent e, MapFrame frame, GeoPoint at) {
        return new MapPointer(
                frame,
                e.getX(),
                e.getY(),
                at,
                SwingUtilities.isRightMouseButton(e),
                e.isShiftDown(),
                e.isShiftDown() || e.isControlDown(),
                e.getClickCount());
    }
}
