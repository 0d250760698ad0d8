package org.sami.boat.server.tcp;

import java.util.concurrent.Executor;
import org.sami.boat.server.BoatServer;

/**
 * Something in the boat's own process that works with its server, such as a link to ground stations of other makers. All methods are called on the boat's thread; they must return at
 * once.
 */
public interface BoatCompanion {
    /**
     * It begins.
     *
     * @param boat to be used on the boat's thread only
     * @param boatThread runs what it is given on that thread
     */
    void begin(BoatServer boat, Executor boatThread, long nowMs);

    /** The boat's server has ticked. */
    void tick(long nowMs);

    /** It ends: the boat's server goes on without it, or stops. */
    void end(long nowMs);
}
