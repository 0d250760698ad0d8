package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.BatteryLevel;
import org.sami.boat.server.testing.Await;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.handler.planning.BoatDemands;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.status.BatteryState;
import org.sami.mavlink.testing.SmallBoat;

/** A vehicle without a current sensor reports no percentage of its charge, as ArduPilot does with BATT_MONITOR 3. */
@Timeout(120)
class UnknownChargeTest {
    private static final int RTL = 11;
    private static final String BOAT = "mav7";
    private static final String DOUBT = BOAT + " cannot report its charge: its autopilot computes none, as without a"
            + " current sensor: only its own battery failsafe tells";
    private static final BatteryState EMPTY = new BatteryState(0, BatteryLevel.CRITICAL);

    @TempDir
    private Path folder;

    private SmallBoat boat;
    private GatewayWorld world;

    @BeforeEach
    void launch() throws Exception {
        boat = new SmallBoat(7, 45.7, 10.72, 20);
        boat.reports().charge(-1);
        world = new GatewayWorld(folder);
        world.connect(boat.address());
        world.untilReady(BOAT);
    }

    @AfterEach
    void end() throws Exception {
        world.close();
        boat.close();
        assertThat(world.faults).isEmpty();
    }

    private void until(String words, Optional<BatteryState> battery) {
        world.until(words, BOAT, proxy -> proxy.status().battery().equals(battery));
    }

    private static Optional<String> doubt(BoatProxy proxy) {
        return BoatDemands.missing(BOAT, proxy.capabilities(), "BatteryLevelSubscription", Map.of());
    }

    @Test
    void batteryFailsafeIsACriticalBatteryAndStaysOneWhileItReportsItself() {
        boat.batteryFailsafe(RTL);

        until("its battery is critical", Optional.of(EMPTY));
        int before = world.events.size();
        Await.until(
                "it has said where it is twice since",
                GatewayWorld.WAIT_S,
                () -> batteries(before).size() >= 2);
        assertThat(batteries(before)).containsOnly(Optional.of(EMPTY));
    }

    private List<Optional<BatteryState>> batteries(int from) {
        return world.events.stream()
                .skip(from)
                .filter(FleetEvent.StatusReported.class::isInstance)
                .map(event -> ((FleetEvent.StatusReported) event).status().battery())
                .toList();
    }

    @Test
    void batteryIsCriticalNoLongerOnceItsAutopilotStartsAgainWithAFullOne() {
        boat.batteryFailsafe(RTL);
        until("its battery is critical", Optional.of(EMPTY));

        boat.restart();

        until("it is not", Optional.of(new BatteryState(100, BatteryLevel.NOMINAL)));
    }

    @Test
    void plansThatWatchTheChargeAreDoubtedUntilItReportsOne() {
        world.until("it says so", BOAT, proxy -> doubt(proxy).equals(Optional.of(DOUBT)));
        assertThat(world.is(BOAT, proxy -> proxy.status().battery().isEmpty())).isTrue();

        boat.reports().charge(87);

        world.until("it reports one", BOAT, proxy -> doubt(proxy).isEmpty());
        until("its charge is known", Optional.of(new BatteryState(87, BatteryLevel.NOMINAL)));
    }
}
