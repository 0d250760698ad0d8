package org.sami.crw.sim.fleet;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.TakenWaypoints;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.spn.protocol.Priority;

/** Whether it is said of a boat that it waits for one that lies at its next waypoint. */
class TakenWaypointsTest {
    private final SimulatedTestWorld world = new SimulatedTestWorld(2);
    private final TakenWaypoints taken = new TakenWaypoints();
    private final List<String> told = new ArrayList<>();

    /** Where boat1 is to go. */
    @BeforeEach
    void putTheOtherOneThere() {
        world.run(2);
        drive("boat2", 3, 0, 20);
        look(30);
    }

    private BoatProxy proxy(String boat) {
        return world.fleet.boat(boat).orElseThrow().proxy();
    }

    private void drive(String boat, long mission, double... eastNorth) {
        proxy(boat)
                .commands()
                .submit(FollowPath.of(
                        "m" + mission + "-" + boat, mission, 1, world.points(eastNorth), Priority.MEDIUM));
    }

    private void look(int seconds) {
        for (int i = 0; i < seconds; i++) {
            world.run(1);
            taken.look(world.fleet.boats().stream().map(SimulatedBoat::proxy).toList())
                    .forEach(one -> told.add(one.words() + ", mission " + one.mission()));
        }
    }

    @Test
    void boatWhoseNextWaypointIsTakenIsNamedOnce() {
        proxy("boat2").abort("for a test");
        drive("boat1", 1, 0, 20, 0, 40);

        look(90);

        assertThat(told).containsExactly("boat1 waits: boat2 lies at its next waypoint, mission 1");
    }

    @Test
    void itIsSaidAgainWhereTheBoatIsSentThereAgain() {
        proxy("boat2").abort("for a test");
        drive("boat1", 1, 0, 20);
        look(60);
        proxy("boat1").commands().withdraw(1);
        look(3);
        drive("boat1", 4, 0, 20);

        look(60);

        assertThat(told).hasSize(2).last().asString().endsWith("mission 4");
    }

    @Test
    void boatForWhichRoomIsMadeIsNotNamed() {
        drive("boat1", 1, 0, 20, 0, 40);

        look(90);

        assertThat(world.recorders.get("boat1").lines).contains("completed m1-boat1");
        assertThat(told).isEmpty();
    }

    @Test
    void boatThatLiesWhereNobodyGoesIsNotNamed() {
        proxy("boat2").abort("for a test");
        drive("boat1", 1, 0, 40);

        look(90);

        assertThat(told).isEmpty();
    }
}
