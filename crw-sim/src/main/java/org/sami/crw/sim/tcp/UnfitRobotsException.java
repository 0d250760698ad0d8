package org.sami.crw.sim.tcp;

import java.io.IOException;
import java.util.List;

/** A run cannot begin, since none of its robots is one that its plan commands. */
public final class UnfitRobotsException extends IOException {
    private static final long serialVersionUID = 1;

    UnfitRobotsException(List<String> unfit) {
        super("nobody is there whom the plan can command: " + String.join("; ", unfit));
    }
}
