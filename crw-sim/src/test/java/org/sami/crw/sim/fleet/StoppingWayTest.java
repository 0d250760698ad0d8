package org.sami.crw.sim.fleet;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.crw.sim.hull.SimulatedHull;

/** How far boats go on after they were told to stop: others reckon with 0.5 m/s² and 0.3 s until they begin to (docs/decisions, 0320). */
class StoppingWayTest {
    private static final double CRUISE_MPS = 1.5;

    private final SimulatedTestWorld world = new SimulatedTestWorld(1);

    @ParameterizedTest
    @CsvSource({"1.5, 0", "2, 0", "2, 90", "2, 170", "3, 0", "3, 90"})
    void boatStopsWithinTheWayThatOthersReckonWith(double mps, double turnDeg) {
        world.run(2);
        world.proxy().settings().setVelocityMultiplier(mps / CRUISE_MPS);
        world.proxy().commands().submit(world.path(1, 0, 200));
        world.run(20);
        double turn = Math.toRadians(turnDeg);
        world.proxy()
                .commands()
                .submit(world.path(2, 200 * Math.sin(turn), world.hull().northM() + 200 * Math.cos(turn)));
        world.run(0.8); // in the middle of the turn
        SimulatedHull hull = world.hull();
        double speedMps = hull.speedMps();
        double eastM = hull.eastM();
        double northM = hull.northM();

        world.proxy().abort("for a test");
        world.run(20);

        assertThat(speedMps).isGreaterThan(mps / 3);
        assertThat(hull.speedMps()).isZero();
        assertThat(world.distanceTo(eastM, northM)).isLessThan(speedMps * 0.3 + speedMps * speedMps / (2 * 0.5));
    }
}
