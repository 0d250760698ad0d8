package org.sami.boat.server.log;

import java.io.IOException;

/** Is notified when a boat's log cannot be written or continued. Called on the thread that drives the boat; the boat drives on. */
public interface LogFaults {
    /** Nothing can be written: until that works again, a restarted boat does not know its last commands. Called once. */
    void unwritable(IOException cause);

    /** No new file can be begun: the present one grows beyond its size until that works again. Called once. */
    void oversized(IOException cause);

    /** A new file was begun, with all that a restarted boat needs: nothing is wrong any more. */
    void mended();
}
