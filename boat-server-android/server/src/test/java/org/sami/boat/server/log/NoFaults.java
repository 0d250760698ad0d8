package org.sami.boat.server.log;

import java.io.IOException;

/** A log at which nothing may go wrong. */
class NoFaults implements LogFaults {
    @Override
    public void unwritable(IOException cause) {
        throw new AssertionError(cause);
    }

    @Override
    public void oversized(IOException cause) {
        throw new AssertionError(cause);
    }

    @Override
    public void mended() {
        throw new AssertionError("nothing was wrong");
    }
}
