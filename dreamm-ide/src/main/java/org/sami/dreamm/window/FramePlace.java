package org.sami.dreamm.window;

import java.awt.Dimension;
import java.awt.Rectangle;
import javax.swing.JFrame;

/**
 * Where a frame lies on the screen.
 *
 * @param state as of {@link JFrame#getExtendedState}
 */
public record FramePlace(Rectangle bounds, Dimension least, int state) {
    static FramePlace of(JFrame frame) {
        return new FramePlace(frame.getBounds(), frame.getMinimumSize(), frame.getExtendedState());
    }

    void give(JFrame frame) {
        frame.setMinimumSize(least);
        frame.setBounds(bounds);
        frame.setExtendedState(state);
    }
}
