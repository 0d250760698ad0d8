package org.sami.crw.sim.tcp;

import java.io.IOException;
import java.util.List;

/** A run cannot begin, since boats did not get ready in time. */
public final class BoatsNotReadyException extends IOException {
    private static final long serialVersionUID = 1;

    BoatsNotReadyException(List<String> missing, long withinMillis) {
        super("not ready after " + withinMillis / 1000.0 + " s: " + String.join("; ", missing));
    }
}
