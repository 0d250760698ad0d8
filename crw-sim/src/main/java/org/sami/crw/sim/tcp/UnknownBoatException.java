package org.sami.crw.sim.tcp;

import java.io.IOException;

/** A setting of the run names a boat that is not among those that have answered. */
public final class UnknownBoatException extends IOException {
    private static final long serialVersionUID = 1;

    UnknownBoatException(String message) {
        super(message);
    }
}
