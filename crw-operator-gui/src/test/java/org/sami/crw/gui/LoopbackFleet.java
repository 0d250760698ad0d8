package org.sami.crw.gui;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.server.tcp.TcpServerListener;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.sim.boat.BoatOnTcp;
import org.sami.crw.sim.boat.BoatSettings;
import org.sami.spn.value.GeoPoint;

/**
 * Simulated boats in this process, in rows of five along the quay of Katara Beach, each behind a loopback socket; each can be ended by
 * itself.
 */
public final class LoopbackFleet implements AutoCloseable {
    /** Where the first one lies. */
    public static final GeoPoint QUAY = GeoPoint.of(25.3597, 51.5268);

    private static final double APART_DEG = 0.0002; // 22 m
    private static final int IN_A_ROW = 5;

    private final Map<String, BoatOnTcp> boats = new LinkedHashMap<>();

    /** Launches one boat a name. */
    public LoopbackFleet(List<String> names) throws IOException {
        for (String name : names) {
            launch(name, name);
        }
    }

    private BoatAddress launch(String key, String name) throws IOException {
        int row = boats.size() / IN_A_ROW;
        GeoPoint at = GeoPoint.of(QUAY.latDeg() - boats.size() % IN_A_ROW * APART_DEG, QUAY.lonDeg() + row * APART_DEG);
        InetSocketAddress anyPort = new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);
        BoatOnTcp boat = new BoatOnTcp(
                BoatSettings.of(name, anyPort, at, boats.size()),
                new SteadyClock(ProcessClock::ms),
                TcpServerListener.NONE);
        boats.put(key, boat);
        return address(boat);
    }

    private static BoatAddress address(BoatOnTcp boat) {
        return new BoatAddress(
                boat.address().getAddress().getHostAddress(), boat.address().getPort());
    }

    /** Where they are connected to. */
    public List<BoatAddress> addresses() {
        return boats.values().stream().map(LoopbackFleet::address).toList();
    }

    /** Launches a second boat with the name of one that is there; gives its address. */
    public BoatAddress launchTwin(String name) throws IOException {
        return launch(name + " again", name);
    }

    /** Ends a boat: nothing comes from it any longer. */
    public void end(String name) throws IOException {
        boats.get(name).close();
    }

    @Override
    public void close() throws IOException {
        for (BoatOnTcp boat : boats.values()) {
            boat.close();
        }
    }
}
