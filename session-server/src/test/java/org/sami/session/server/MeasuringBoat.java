package org.sami.session.server;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.List;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.server.tcp.TcpServerListener;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.session.Session;
import org.sami.crw.sim.boat.BoatOnTcp;
import org.sami.crw.sim.boat.BoatSettings;
import org.sami.crw.sim.hull.Conditions;
import org.sami.crw.sim.hull.SensorKind;
import org.sami.crw.sim.hull.SensorSetting;
import org.sami.spn.value.GeoPoint;

/** The boat bella on loopback, which measures temperature and oxygen five times a second. */
final class MeasuringBoat implements AutoCloseable {
    private final BoatOnTcp boat;

    MeasuringBoat() throws Exception {
        boat = new BoatOnTcp(
                BoatSettings.of(
                                "bella",
                                new InetSocketAddress(InetAddress.getLoopbackAddress(), 0),
                                GeoPoint.of(45.4, 10.9),
                                1)
                        .on(Conditions.CALM.measuring(List.of(
                                new SensorSetting(SensorKind.TEMPERATURE, 5),
                                new SensorSetting(SensorKind.OXYGEN, 5)))),
                new SteadyClock(ProcessClock::ms),
                TcpServerListener.NONE);
    }

    /** Connects a session to it. */
    void join(Session session) throws Exception {
        session.fleet()
                .connect(new BoatAddress(
                        boat.address().getAddress().getHostAddress(),
                        boat.address().getPort()))
                .toCompletableFuture()
                .get();
    }

    @Override
    public void close() throws Exception {
        boat.close();
    }
}
