package org.sami.ui.dock;

import java.awt.GraphicsConfiguration;
import java.awt.GraphicsDevice;
import java.awt.GraphicsEnvironment;
import java.awt.Insets;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import javax.swing.JFrame;

/**
 * Keeps a window on the screens that are there. An arrangement is often remembered from a larger screen; what lies outside of the present ones cannot be
 * seen or clicked, the fleet stop included. Rectangles are in pixels of the desktop. On the event thread.
 */
final class ScreenFit {
    private ScreenFit() {}

    /** Moves a frame into the room that the screens have for windows, and makes it smaller where it must be. */
    static void into(JFrame frame) {
        Rectangle fit = fit(frame.getBounds(), screens());
        if (!fit.equals(frame.getBounds())) {
            frame.setBounds(fit);
        }
    }

    /** Where a window is to lie: where it is, if all of it can be seen there; else inside the screen that shows most of it, or inside the first one. */
    static Rectangle fit(Rectangle window, List<Rectangle> screens) {
        long seen = screens.stream().mapToLong(screen -> area(window, screen)).sum();
        if (screens.isEmpty() || seen >= (long) window.width * window.height) {
            return window;
        }
        Rectangle screen = screens.stream()
                .max(Comparator.comparingLong(one -> area(window, one)))
                .filter(most -> area(window, most) > 0)
                .orElse(screens.get(0));
        int width = Math.min(window.width, screen.width);
        int height = Math.min(window.height, screen.height);
        int x = Math.max(screen.x, Math.min(window.x, screen.x + screen.width - width));
        int y = Math.max(screen.y, Math.min(window.y, screen.y + screen.height - height));
        return new Rectangle(x, y, width, height);
    }

    private static long area(Rectangle window, Rectangle screen) {
        Rectangle common = window.intersection(screen);
        return common.isEmpty() ? 0 : (long) common.width * common.height;
    }

    /** The room for windows of each screen, the default screen first. */
    private static List<Rectangle> screens() {
        GraphicsEnvironment environment = GraphicsEnvironment.getLocalGraphicsEnvironment();
        List<Rectangle> screens = new ArrayList<>();
        screens.add(room(environment.getDefaultScreenDevice()));
        for (GraphicsDevice device : environment.getScreenDevices()) {
            if (!device.equals(environment.getDefaultScreenDevice())) {
                screens.add(room(device));
            }
        }
        return screens;
    }

    private static Rectangle room(GraphicsDevice device) {
        GraphicsConfiguration configuration = device.getDefaultConfiguration();
        Rectangle bounds = configuration.getBounds();
        Insets taken = Toolkit.getDefaultToolkit().getScreenInsets(configuration);
        return new Rectangle(
                bounds.x + taken.left,
                bounds.y + taken.top,
                bounds.width - taken.left - taken.right,
                bounds.height - taken.top - taken.bottom);
    }
}
