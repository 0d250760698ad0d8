package org.sami.crw.session;

import java.io.IOException;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.spn.value.GeoPoint;

/** Launches simulated boats, and has it remembered that they are: they end with their process, and a later one launches them again. */
final class RememberedSimulation implements SimulatedBoats {
    private final SimulatedBoats boats;
    private final RememberedBoats memory;

    RememberedSimulation(SimulatedBoats boats, RememberedBoats memory) {
        this.boats = boats;
        this.memory = memory;
    }

    @Override
    public BoatAddress launch(String boat, GeoPoint at) throws IOException {
        BoatAddress address = boats.launch(boat, at);
        memory.simulatedAt(boat, at);
        return address;
    }

    @Override
    public void close() {
        boats.close();
    }
}
