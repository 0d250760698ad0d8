package org.sami.crw.session;

import java.io.IOException;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.spn.value.GeoPoint;

/** Launches simulated boats for a session over TCP: each has a server of its own, and is reached as any other boat. */
public interface SimulatedBoats extends AutoCloseable {
    /**
     * Launches a boat.
     *
     * @param boat its id
     * @return where its server listens
     * @throws IOException if it cannot have a port
     */
    BoatAddress launch(String boat, GeoPoint at) throws IOException;

    /** Ends all boats that were launched. */
    @Override
    void close();
}
