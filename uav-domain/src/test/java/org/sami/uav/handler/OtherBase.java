package org.sami.uav.handler;

import org.sami.boat.server.ServerSession;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.link.ProxyConfig;
import org.sami.crw.sim.clock.VirtualClock;
import org.sami.crw.sim.fleet.SimulatedBoat;
import org.sami.crw.sim.link.InMemoryPipe;
import org.sami.crw.sim.link.PipeConfig;

/** Another base than the one under test, on a link of its own to a simulated copter. */
final class OtherBase {
    private static final long TICK_MS = 100;

    final BoatProxy proxy;
    private final VirtualClock clock;

    OtherBase(VirtualClock clock, SimulatedBoat boat) {
        this.clock = clock;
        InMemoryPipe toBoat = new InMemoryPipe(clock, PipeConfig.DEFAULT, 1);
        InMemoryPipe toBase = new InMemoryPipe(clock, PipeConfig.DEFAULT, 2);
        proxy = new BoatProxy(boat.id(), toBoat, event -> {}, ProxyConfig.DEFAULT.withClientId("other"));
        ServerSession session = boat.server().connect(toBase);
        toBoat.connect(session::receive);
        toBase.connect(proxy::receive);
        tick();
    }

    private void tick() {
        proxy.tick(clock.nowMs());
        clock.at(clock.nowMs() + TICK_MS, this::tick);
    }
}
