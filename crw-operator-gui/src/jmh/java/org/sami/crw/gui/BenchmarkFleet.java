package org.sami.crw.gui;

import java.io.IOException;
import java.util.List;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.sim.bench.FleetProcess;
import org.sami.mavlink.testing.SmallBoatProcess;
import org.sami.spn.value.GeoPoint;

/**
 * Boats in a process of their own, so that what they need is not counted for the window.
 *
 * @param hz how many poses each sends a second
 * @param pier where they lie
 * @param addresses theirs, in order
 * @param process ends with this
 */
record BenchmarkFleet(int hz, GeoPoint pier, List<BoatAddress> addresses, AutoCloseable process)
        implements AutoCloseable {
    /** Boats of ours, over TCP. */
    static BenchmarkFleet ours(int boats) throws IOException {
        FleetProcess process = new FleetProcess(boats);
        List<BoatAddress> addresses = process.addresses().stream()
                .map(at -> new BoatAddress(at.getAddress().getHostAddress(), at.getPort()))
                .toList();
        return new BenchmarkFleet(10, FleetProcess.PIER, addresses, process);
    }

    /** Vehicles that speak MAVLink, each on a TCP link of its own. */
    static BenchmarkFleet vehicles(int boats) throws IOException {
        SmallBoatProcess process = new SmallBoatProcess(boats);
        List<BoatAddress> addresses =
                process.addresses().stream().map(BoatAddress::parse).toList();
        GeoPoint pier = GeoPoint.of(SmallBoatProcess.LAT_DEG, SmallBoatProcess.LON_DEG);
        return new BenchmarkFleet(4, pier, addresses, process);
    }

    @Override
    public void close() throws Exception {
        process.close();
    }
}
