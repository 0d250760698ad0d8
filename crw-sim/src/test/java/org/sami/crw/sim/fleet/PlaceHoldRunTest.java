package org.sami.crw.sim.fleet;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.sami.boat.link.BoatMode;
import org.sami.crw.sim.hull.NamedConditions;

/** True tracks of boats whose paths were given up: they stay where they were (docs/services.md). */
class PlaceHoldRunTest {
    private static final double KEPT_M = 5; // what a boat that keeps a station lets itself drift

    private static final double DEVIATIONS = 4; // of the position that it knows, as it is exceeded in twenty minutes

    private static SimulatedTestWorld givenUp(NamedConditions water, long seed) {
        SimulatedTestWorld world =
                new SimulatedTestWorld(1, seed, FleetConfig.DEFAULT.withConditions(water.conditions()));
        world.run(1);
        world.proxy().settings().setVelocityMultiplier(0.01); // weaker than the current for a while
        world.run(1);
        world.proxy().commands().submit(world.path(1, -500, 0));
        for (int i = 0; i < 900 && world.reports().stream().noneMatch(line -> line.startsWith("failed")); i++) {
            world.run(1);
        }
        assertThat(world.reports()).anyMatch(line -> line.startsWith("failed"));
        world.proxy().settings().setVelocityMultiplier(1);
        return world;
    }

    @ParameterizedTest
    @EnumSource(names = {"FIELD", "ROUGH"})
    void aBoatWhosePathWasGivenUpStaysWhereKeepersStay(NamedConditions water) {
        for (long seed = 1; seed <= 5; seed++) {
            SimulatedTestWorld world = givenUp(water, seed);
            double eastM = world.hull().eastM();
            double northM = world.hull().northM();

            double farthestM = 0;
            for (int i = 0; i < 1200; i++) {
                world.run(1);
                farthestM = Math.max(farthestM, world.distanceTo(eastM, northM));
            }

            double positionM = water.conditions().crossTrackError().positionM();
            assertThat(farthestM).as("%s, seed %d", water, seed).isLessThan(KEPT_M + 2 * DEVIATIONS * positionM);
        }
    }

    @ParameterizedTest
    @EnumSource(names = {"FIELD", "ROUGH"})
    void itLeavesItsPlaceForTheNextCommand(NamedConditions water) {
        SimulatedTestWorld world = givenUp(water, 1);
        world.run(60);

        world.proxy().commands().submit(world.path(2, 0, 80));
        world.run(300);

        assertThat(world.reports()).anyMatch(line -> line.startsWith("completed m2"));
    }

    @ParameterizedTest
    @EnumSource(names = {"FIELD", "ROUGH"})
    void itRestsWithItsMotorsOffWhenItIsStopped(NamedConditions water) {
        SimulatedTestWorld world = givenUp(water, 1);
        world.run(60);
        double eastM = world.hull().eastM();
        double northM = world.hull().northM();

        world.proxy().abort("for a test");
        world.run(600);

        assertThat(world.proxy().status().mode()).contains(BoatMode.STOPPED);
        assertThat(world.distanceTo(eastM, northM)).as("it drifts").isGreaterThan(50);
    }
}
