package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.server.testing.Await;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.status.LinkState;
import org.sami.mavlink.testing.ArduPilotBoats;
import org.sami.mavlink.testing.SimulatorTruth;
import org.sami.mavlink.testing.TcpRelay;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/** ArduPilot's real firmware for boats on two of its ports, of which one after the other is out of range. */
@Tag("long")
@Timeout(900)
class ArduPilotTwoLinksTest {
    private static final int NUMBER = 46;
    private static final int SPEED = 4;
    private static final String BOAT = "mav" + (NUMBER + 1);
    private static final double MISSION_S = 120;
    private static final double RADIUS_M = 2.5;
    private static final double M_PER_DEG = 111_195;

    @TempDir
    private Path work;

    private static GeoPoint off(GeoPoint from, double northM, double eastM) {
        double east = eastM / Math.cos(Math.toRadians(from.latDeg()));
        return GeoPoint.of(from.latDeg() + northM / M_PER_DEG, from.lonDeg() + east / M_PER_DEG);
    }

    @Test
    void boatDrivesItsPathWhileOneLinkAfterTheOtherIsOutOfRange() throws Exception {
        assumeTrue(ArduPilotBoats.areThere(), ArduPilotBoats::missing);
        try (ArduPilotBoats boats = new ArduPilotBoats(NUMBER, 1, SPEED, work);
                TcpRelay one = new TcpRelay(ArduPilotBoats.secondPort(NUMBER));
                TcpRelay other = new TcpRelay(ArduPilotBoats.thirdPort(NUMBER));
                GatewayWorld world = new GatewayWorld(work.resolve("vehicles"))) {
            world.connect(one.address());
            world.connect(other.address());
            world.until(
                    "it is ready",
                    BOAT,
                    boat -> boat.isCommanding() && boat.status().pose().isPresent());
            Await.until("both links are its own", GatewayWorld.WAIT_S, () -> isSaid(world, BOAT + " is heard on "));
            try (SimulatorTruth truth = new SimulatorTruth(ArduPilotBoats.firstPort(NUMBER), NUMBER + 1)) {
                GeoPoint start = world.ask(
                        BOAT, boat -> boat.status().pose().orElseThrow().position());
                List<GeoPoint> path =
                        List.of(off(start, 30, 0), off(start, 30, 30), off(start, 0, 30), off(start, 0, 3));
                world.tell(BOAT, boat -> boat.commands().submit(FollowPath.of("path", 1, 1, path, Priority.MEDIUM)));
                visited(world, 1);
                one.cut(true);
                visited(world, 2);
                one.cut(false);
                other.cut(true);
                visited(world, 3);
                other.cut(false); // over whichever it was commanded in the beginning, each has taken it over once
                one.cut(true);
                Await.until("it is there", MISSION_S, () -> world.has(FleetEvent.CommandCompleted.class, done -> true));

                assertThat(path)
                        .allSatisfy(place -> assertThat(truth.nearestM(place.latDeg(), place.lonDeg()))
                                .isLessThan(RADIUS_M));
                assertThat(Stream.of(one, other))
                        .allMatch(link -> isSaid(world, "commanded over " + link.address() + " from now on"));
                assertThat(world.has(
                                FleetEvent.LinkChanged.class,
                                change -> change.status().link() == LinkState.LOST))
                        .isFalse();
                assertThat(world.has(FleetEvent.CommandFailed.class, failed -> true))
                        .isFalse();
                assertThat(world.faults).isEmpty();
            }
        }
    }

    private static boolean isSaid(GatewayWorld world, String words) {
        return world.alarms.stream().anyMatch(text -> text.contains(words));
    }

    private static void visited(GatewayWorld world, int points) {
        Await.until(
                points + " are visited",
                MISSION_S,
                () -> world.has(FleetEvent.Progressed.class, news -> news.visited() == points));
    }
}
