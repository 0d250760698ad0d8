package org.sami.crw.sim.fleet;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.boat.link.BatteryLevel;
import org.sami.crw.proxy.status.BatteryState;
import org.sami.crw.sim.hull.Conditions;
import org.sami.crw.sim.hull.Flow;

/** A boat whose thresholds know nothing of its area turns critical while it can still come home from where it is. */
class WayHomeTest {
    private static final long SEEDS = 10;

    @ParameterizedTest
    @CsvSource({"100, 0, 0@0, 0@0", "60, 0, 0@0, 0@0", "100, 1.4, 0.15@90, 3@270", "60, 1.4, 0.15@180, 3@0"})
    void boatThatTurnsCriticalComesHomeWithChargeLeft(double percent, double gpsM, String current, String wind) {
        Conditions water = new Conditions(gpsM, 4, Flow.parse(current), Flow.parse(wind), List.of());
        for (long seed = 1; seed <= SEEDS; seed++) {
            SimulatedTestWorld world = new SimulatedTestWorld(1, seed, FleetConfig.DEFAULT.withConditions(water));
            world.run(1);
            world.hull().setBatteryPercent(percent);
            double bearing = seed * 2 * Math.PI / SEEDS;
            world.proxy().commands().submit(world.path(1, 5000 * Math.sin(bearing), 5000 * Math.cos(bearing)));
            for (int i = 0; i < 4000 && !isCritical(world); i++) {
                world.run(1);
            }
            double turnedM = world.distanceTo(0, 0);
            world.proxy().commands().withdraw(1);
            world.proxy().commands().submit(world.path(2, 0, 0));
            for (int i = 0; i < 4000 && !isHome(world); i++) {
                world.run(1);
                assertThat(isCritical(world)).as("seed %d", seed).isTrue();
            }

            assertThat(isHome(world))
                    .as("seed %d, turned %.0f m out", seed, turnedM)
                    .isTrue();
            assertThat(world.hull().batteryPercent()).as("seed %d", seed).isPositive();
            assertThat(turnedM).as("seed %d", seed).isGreaterThan(10 * percent);
        }
    }

    private static boolean isCritical(SimulatedTestWorld world) {
        return world.proxy()
                .status()
                .battery()
                .map(BatteryState::level)
                .filter(BatteryLevel.CRITICAL::equals)
                .isPresent();
    }

    private static boolean isHome(SimulatedTestWorld world) {
        return world.reports().contains("completed m2-boat1");
    }
}
