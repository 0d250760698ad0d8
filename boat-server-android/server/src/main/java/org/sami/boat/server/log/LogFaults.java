package org.sami.boat.server.log;

import java.io.IOException;

/** Gets to know when a boat's log cannot be kept as it should be. Called on the thread that drives the boat; the boat goes on. */
public interface LogFaults {
    /** Nothing can be written: until it is mended, a restarted boat does not know its last commands. Called once. */
    void unwritable(IOException cause);

    /** No new file can be begun: the present one grows beyond its size until that is mended. Called once. */
    void oversized(IOException cause);

    /** A new file was begun, with all that a restarted boat needs: nothing is wrong any more. */
    void mended();
}
