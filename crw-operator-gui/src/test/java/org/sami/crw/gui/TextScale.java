package org.sami.crw.gui;

import static org.sami.crw.gui.EventThreadCall.onEventThread;

import org.sami.palette.Theme;
import org.sami.ui.look.Look;

/** Text of another size in the light look, until it is closed: for tests that no other test of a window runs at the same time. */
public final class TextScale implements AutoCloseable {
    private static final int STANDARD_PERCENT = 100;

    private TextScale() {}

    /** From now on text is so large, in percent of its standard size. */
    public static TextScale percent(int percent) {
        apply(percent);
        return new TextScale();
    }

    @Override
    public void close() {
        apply(STANDARD_PERCENT);
    }

    private static void apply(int percent) {
        onEventThread(() -> {
            Look.apply(Theme.LIGHT, percent);
            return null;
        });
    }
}
