package org.sami.crw.gui.robot;

import java.awt.Component;
import java.awt.Container;
import java.awt.Rectangle;
import java.util.Map;
import java.util.TreeMap;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import org.sami.ui.check.Layout;
import org.sami.ui.check.WindowRobot;
import org.sami.ui.dock.DockPanel;

/**
 * Where in a window that lies which must not move: the fleet stop, the row of health, and the side of every panel. Panels above and below
 * one another share their height by what waits in them (docs/windows.md).
 */
final class FixedControls {
    private static final String STOP = "fleet-stop";

    private final JFrame frame;

    FixedControls(JFrame frame) {
        this.frame = frame;
    }

    /** Where they lie once no new share of room is under way, by their names; without panels that have no room. */
    Map<String, Rectangle> places() {
        return WindowRobot.still(() -> {
            Map<String, Rectangle> places = new TreeMap<>();
            add(frame.getRootPane(), places);
            places.values().removeIf(place -> place.width == 0);
            return places;
        });
    }

    private void add(Container root, Map<String, Rectangle> places) {
        for (Component child : root.getComponents()) {
            boolean fixed = STOP.equals(child.getName()) || "health-row".equals(child.getName());
            if (child.isShowing() && (fixed || child instanceof DockPanel)) {
                Rectangle at = SwingUtilities.convertRectangle(root, child.getBounds(), frame.getRootPane());
                places.put(child.getName(), fixed ? at : new Rectangle(at.x, 0, at.width, 0));
            }
            if (child instanceof Container inner && !(child instanceof DockPanel)) {
                add(inner, places);
            }
        }
    }

    /** What the pointer would meet on the fleet stop: it, unless something covers it. */
    String underTheStop() {
        return WindowRobot.ask(() -> {
            Component stop = Layout.find(frame, STOP, Component.class).orElseThrow();
            Rectangle at = SwingUtilities.convertRectangle(stop.getParent(), stop.getBounds(), frame.getLayeredPane());
            Component met = SwingUtilities.getDeepestComponentAt(
                    frame.getLayeredPane(), (int) at.getCenterX(), (int) at.getCenterY());
            return met == null ? "nothing" : String.valueOf(met.getName());
        });
    }
}
