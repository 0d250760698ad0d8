package org.sami.uav.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayDeque;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sami.crw.handler.boat.FlightUseMemory;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.reach.Endurance;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.host.EngineHost;
import org.sami.spn.host.EngineHostBuilder;
import org.sami.spn.host.HostClock;
import org.sami.spn.value.GeoPoint;

/** What copters use in the air, in bases that go on with the state of the one before. */
class FlightUseMemoryTest {
    private final Engine engine = new Engine(UavRuns.DOMAIN.vocabulary(), UavRuns.DOMAIN.combined());
    private final EngineState state = engine.newState();
    private final ArrayDeque<Runnable> work = new ArrayDeque<>();

    private static final class Standing implements HostClock {
        @Override
        public long nowMillis() {
            return 0;
        }

        @Override
        public void wakeAt(long millis, Runnable action) {}
    }

    /** A base with one copter, which it does not know. */
    private FlightHandlerHarness base() {
        EngineHost host = EngineHostBuilder.of(engine, state)
                .clock(new Standing())
                .executor(work::add)
                .build();
        FlightHandlerHarness base = new FlightHandlerHarness(1);
        FlightUseMemory memory = new FlightUseMemory(host, base.fleet.proxies());
        base.listen(event -> {
            memory.accept(event);
            drain();
        });
        base.pass(5);
        return base;
    }

    private void drain() {
        while (!work.isEmpty()) {
            work.remove().run();
        }
    }

    private static Endurance endurance(FlightHandlerHarness base) {
        return base.proxy("copter1").endurance().orElseThrow();
    }

    @Test
    void baseThatGoesOnKnowsWhatTheOneBeforeSaw() {
        FlightHandlerHarness first = base();
        assertThat(endurance(first).isSeen()).isFalse();
        GeoPoint home = first.flights.position("copter1").orElseThrow();
        first.activate(
                new FlyToHandler(first.flights, first.taskFlights()),
                Map.of("location", Flights.at(Geodesy.offset(home, 0, 100), 30)),
                "copter1");
        first.pass(120);

        Endurance seen = endurance(first);
        Endurance after = endurance(base());

        assertThat(List.of(seen.isSeen(), after.isSeen())).containsOnly(true);
        assertThat(after.percentPerS()).isCloseTo(seen.percentPerS(), org.assertj.core.data.Offset.offset(0.005));
    }
}
