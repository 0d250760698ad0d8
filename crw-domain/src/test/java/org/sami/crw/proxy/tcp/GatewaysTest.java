package org.sami.crw.proxy.tcp;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.link.ProxyConfig;

/** Links through gateways of other protocols. */
class GatewaysTest {
    @Test
    void linkThroughAGatewayThatCannotBeginSaysWhyAndIsNoFaultOfTheProgram() {
        List<String> faults = new CopyOnWriteArrayList<>();
        BaseListener listener = new BaseListener() {
            @Override
            public Consumer<FleetEvent> found(String boatId) {
                return event -> {};
            }

            @Override
            public void onFailure(String what, RuntimeException cause) {
                faults.add(what + ": " + cause);
            }
        };
        try (TcpBase base =
                new TcpBase(TcpBaseConfig.of(ProxyConfig.DEFAULT, 1), new SteadyClock(ProcessClock::ms), listener)) {
            base.connect(BoatAddress.parse("mavlink:tcp:127.0.0.1:1/1").toSocketAddress());

            Await.until(
                    "it says why",
                    () -> base.links().join().stream()
                            .anyMatch(link -> link.lastEvent().contains(KeylessGatewayMaker.WHY)));
            assertThat(base.links().join()).noneMatch(LinkReport::connected);
        }
        assertThat(faults).isEmpty();
    }
}
