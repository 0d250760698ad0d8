package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.server.testing.Await;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.mavlink.testing.ArduPilotBoats;
import org.sami.mavlink.testing.SimulatorTruth;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/**
 * Boats with the real firmware whose paths meet; where they truly were, their simulators say. In real time, as the base steers them; with {@code
 * -PvehicleMissions}, as it takes minutes.
 */
@Timeout(900)
class ArduPilotGivingWayTest {
    private static final int FIRST = 93;
    private static final int BOATS = 3;
    private static final double BOOT_S = 300;
    private static final double MISSION_S = 300;
    private static final double APART_M = 2;

    @TempDir
    private Path work;

    @Test
    void boatsThatMeetAndCrossKeepApartAndComeToTheirEnds() throws Exception {
        assumeTrue(Boolean.getBoolean("crw.vehicleMissions"), "minutes on real firmware: only with -PvehicleMissions");
        assumeTrue(ArduPilotBoats.areThere(), ArduPilotBoats::missing);
        try (ArduPilotBoats boats = new ArduPilotBoats(FIRST, BOATS, 1, work);
                GatewayWorld world = new GatewayWorld(work.resolve("vehicles"));
                Truths truths = new Truths()) {
            List<GeoPoint> starts = ready(world, BOATS, truths);

            // the outer two to each other's place; the middle one across their line and back
            submit(world, 0, off(starts.get(2), -1), off(starts.get(2), 12));
            submit(world, 2, off(starts.get(0), 1), off(starts.get(0), -12));
            submit(world, 1, off(starts.get(1), -15), off(starts.get(1), 15));
            for (int i = 0; i < BOATS; i++) {
                isCompleted(world, i);
            }

            assertThat(truths.all.get(0).closestM(truths.all.get(2))).isBetween(APART_M, 20.0); // they have met
            assertThat(truths.all.get(0).closestM(truths.all.get(1))).isGreaterThan(APART_M);
            assertThat(truths.all.get(1).closestM(truths.all.get(2))).isGreaterThan(APART_M);
            assertThat(world.alarms).noneMatch(text -> text.contains("taken"));
            assertThat(world.faults).isEmpty();
        }
    }

    /** Where boats truly are. */
    private static final class Truths implements AutoCloseable {
        private final List<SimulatorTruth> all = new ArrayList<>();

        @Override
        public void close() throws Exception {
            for (SimulatorTruth truth : all) {
                truth.close();
            }
        }
    }

    /** Connects boats and waits until each says where it is: these places. */
    private static List<GeoPoint> ready(GatewayWorld world, int count, Truths truths) throws Exception {
        for (int i = FIRST; i < FIRST + count; i++) {
            world.connect(ArduPilotBoats.address(i) + "/" + (i + 1));
        }
        List<GeoPoint> starts = new ArrayList<>();
        for (int i = FIRST; i < FIRST + count; i++) {
            String boat = boat(i);
            Await.until(
                    boat + " is ready",
                    BOOT_S,
                    () -> world.is(
                            boat,
                            proxy -> proxy.isCommanding()
                                    && proxy.status().pose().isPresent()));
            truths.all.add(new SimulatorTruth(ArduPilotBoats.secondPort(i), i + 1));
            starts.add(
                    world.ask(boat, proxy -> proxy.status().pose().orElseThrow().position()));
        }
        return starts;
    }

    private static void isCompleted(GatewayWorld world, int boat) {
        String path = "p" + boat;
        Await.until(
                path + " is completed",
                MISSION_S,
                () -> world.has(
                        FleetEvent.CommandCompleted.class,
                        done -> done.command().commandId().equals(path)));
    }

    /** The first one's path ends where the other has to pass. */
    @Test
    void boatAtTheEndOfItsPathMakesRoom() throws Exception {
        assumeTrue(Boolean.getBoolean("crw.vehicleMissions"), "minutes on real firmware: only with -PvehicleMissions");
        assumeTrue(ArduPilotBoats.areThere(), ArduPilotBoats::missing);
        try (ArduPilotBoats boats = new ArduPilotBoats(FIRST, 2, 1, work);
                GatewayWorld world = new GatewayWorld(work.resolve("vehicles"));
                Truths truths = new Truths()) {
            List<GeoPoint> starts = ready(world, 2, truths);

            submit(world, 0, off(starts.get(0), 20), off(starts.get(0), 40));
            isCompleted(world, 0);
            long beganMs = System.nanoTime() / 1_000_000;
            submit(world, 1, off(starts.get(0), 20), off(starts.get(0), 37), off(starts.get(0), 60));
            isCompleted(world, 1);

            System.out.printf(
                    "boat that had to pass: %.0f s, %.2f m at the closest%n",
                    (System.nanoTime() / 1_000_000 - beganMs) / 1000.0,
                    truths.all.get(0).closestM(truths.all.get(1)));
            assertThat(truths.all.get(0).closestM(truths.all.get(1))).isGreaterThan(APART_M);
            assertThat(world.alarms).noneMatch(text -> text.contains("taken"));
            assertThat(world.faults).isEmpty();
        }
    }

    private static String boat(int number) {
        return "mav" + (number + 1);
    }

    private static GeoPoint off(GeoPoint point, double northM) {
        return GeoPoint.of(point.latDeg() + northM / 111_190, point.lonDeg());
    }

    private static void submit(GatewayWorld world, int boat, GeoPoint... points) {
        world.tell(
                boat(FIRST + boat),
                proxy -> proxy.commands().submit(FollowPath.of("p" + boat, 1, 1, List.of(points), Priority.MEDIUM)));
    }
}
