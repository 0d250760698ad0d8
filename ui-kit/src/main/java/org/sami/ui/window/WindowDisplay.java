package org.sami.ui.window;

import java.awt.AWTError;
import java.awt.GraphicsEnvironment;
import java.awt.HeadlessException;

/** The display that windows open on. */
public final class WindowDisplay {
    private WindowDisplay() {}

    /** Whether a window can be opened: there is a display, and it can be reached. */
    public static boolean isThere() {
        try {
            return !GraphicsEnvironment.isHeadless()
                    && GraphicsEnvironment.getLocalGraphicsEnvironment().getScreenDevices().length > 0;
        } catch (HeadlessException | AWTError unreachable) {
            return false;
        }
    }
}
