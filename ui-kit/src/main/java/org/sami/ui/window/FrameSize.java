package org.sami.ui.window;

import java.awt.Dimension;
import java.awt.GraphicsEnvironment;
import java.awt.Rectangle;
import javax.swing.JFrame;

/** The size of a program's window. On the event thread. */
public final class FrameSize {
    private static final Dimension FIRST = new Dimension(1600, 1000);
    private static final Dimension LEAST = new Dimension(1000, 640);

    private FrameSize() {}

    /** Shows a frame in the middle of the screen, as large as the screen allows up to 1600 by 1000. */
    public static void show(JFrame frame) {
        Rectangle screen = GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds();
        frame.setMinimumSize(LEAST);
        frame.setSize(Math.min(FIRST.width, screen.width), Math.min(FIRST.height, screen.height));
        frame.setLocationRelativeTo(null);
        frame.setVisible(true);
    }
}
