package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.BoatMode;
import org.sami.boat.server.testing.Await;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.mavlink.testing.ArduPilotBoats;
import org.sami.mavlink.testing.SimulatorTruth;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/** The real firmware of a boat under a base's commands; where it truly was, its simulator says. */
@Timeout(900)
class ArduPilotBoatTest {
    private static final int NUMBER = 90; // far from where somebody tries one by hand
    private static final int SPEED = 5;
    private static final double BOOT_S = 300;
    private static final double MISSION_S = 300;
    private static final double RADIUS_M = 3;
    private static final String BOAT = "mav" + (NUMBER + 1);

    @TempDir
    private Path work;

    @Test
    void followsAPathAndGoesToAPlaceTrulyWithinTheRadius() throws Exception {
        assumeTrue(ArduPilotBoats.areThere(), ArduPilotBoats::missing);
        try (ArduPilotBoats boats = new ArduPilotBoats(NUMBER, 1, SPEED, work);
                GatewayWorld world = new GatewayWorld(work.resolve("vehicles"))) {
            world.connect(ArduPilotBoats.address(NUMBER));
            Await.until(
                    "it is ready",
                    BOOT_S,
                    () -> world.is(
                            BOAT,
                            boat -> boat.isCommanding() && boat.status().pose().isPresent()));
            try (SimulatorTruth truth = new SimulatorTruth(ArduPilotBoats.secondPort(NUMBER), NUMBER + 1)) {
                GeoPoint start = start(world);
                List<GeoPoint> path = List.of(off(start, 15, 0), off(start, 15, 15), off(start, 0, 15));
                submit(world, FollowPath.of("path", 1, 1, path, Priority.MEDIUM));
                completes(world, "path");
                GeoPoint back = off(start, 0, 3);
                submit(world, FollowPath.of("back", 1, 2, List.of(back), Priority.MEDIUM));
                completes(world, "back");
                world.tell(BOAT, BoatProxy::fleetStop);
                world.until(
                        "it is stopped", BOAT, boat -> boat.status().mode().equals(Optional.of(BoatMode.FLEET_STOP)));

                assertThat(List.of(path.get(0), path.get(1), path.get(2), back))
                        .allSatisfy(place -> assertThat(truth.nearestM(place.latDeg(), place.lonDeg()))
                                .isLessThan(RADIUS_M));
                assertThat(world.faults).isEmpty();
            }
        }
    }

    private static GeoPoint start(GatewayWorld world) {
        return world.ask(BOAT, boat -> boat.status().pose().orElseThrow().position());
    }

    private static GeoPoint off(GeoPoint from, double northM, double eastM) {
        double degree = 111_319;
        return GeoPoint.of(
                from.latDeg() + northM / degree,
                from.lonDeg() + eastM / (degree * Math.cos(Math.toRadians(from.latDeg()))));
    }

    private static void submit(GatewayWorld world, FollowPath path) {
        world.tell(BOAT, boat -> boat.commands().submit(path));
    }

    private static void completes(GatewayWorld world, String command) {
        Await.until(
                command + " is over",
                MISSION_S,
                () -> world.has(
                                FleetEvent.CommandCompleted.class,
                                done -> done.command().commandId().equals(command))
                        || world.has(FleetEvent.CommandFailed.class, failed -> {
                            throw new AssertionError(failed.reason());
                        }));
    }
}
