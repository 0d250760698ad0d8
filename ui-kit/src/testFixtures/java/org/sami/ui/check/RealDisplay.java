package org.sami.ui.check;

import java.awt.GraphicsEnvironment;
import org.junit.jupiter.api.Assumptions;

/** The display that a test of a real window needs; the build brings one where Xvfb and openbox are installed. */
public final class RealDisplay {
    private RealDisplay() {}

    /** Skips the test where there is no display, and says how to get one. */
    public static void assumed() {
        Assumptions.assumeFalse(
                GraphicsEnvironment.isHeadless(),
                () -> "there is no display; get one by: " + System.getProperty("window.install"));
    }
}
