package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.Ack;
import org.sami.boat.link.HeldWaypoints;
import org.sami.boat.link.Progress;
import org.sami.boat.link.ReadBack;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.testing.Await;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.mavlink.testing.SmallBoat;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/** A path that is longer than what a vehicle holds, in parts while it drives. */
@Tag("long")
@Timeout(900)
class LongPathTest {
    private static final double WAIT_S = 600; // a machine that does much else drives slowly
    private static final int LOCATIONS = 2_000;
    private static final int TIMES = 150; // some 70 waypoints a second
    private static final List<Waypoint> PATH = IntStream.range(0, LOCATIONS)
            .mapToObj(i -> new Waypoint(45.7 + i * 2e-5, 10.72 + i % 7 * 1e-6, i < 1_000 ? 1 : 1.2))
            .toList();

    /** Longer than a vehicle holds, so that it is sent in parts, and driven in half the time. */
    private static final List<Waypoint> HALF = PATH.subList(0, LOCATIONS / 2);

    private static final int ROW = 110;
    private static final int BEFORE_ITS_FIRST = 2; // items: home, and the speed
    private static final int NEAR_TURN = 20; // it drives on for the time of a tick and of a transfer

    @TempDir
    private Path folder;

    private SmallBoat boat;
    private LinkClient client;

    @BeforeEach
    void launch() throws Exception {
        launch(PATH.get(0));
    }

    private void launch(Waypoint place) throws Exception {
        boat = new SmallBoat(5, place.latDeg(), place.lonDeg(), TIMES);
        client = new LinkClient(folder, boat.address() + "/5");
    }

    @AfterEach
    void end() throws Exception {
        client.close();
        boat.close();
    }

    private void start() {
        assertThat(client.ask(new UploadWaypoints("upload", "long", HALF))).isInstanceOf(Ack.class);
        assertThat(client.ask(new ReadBack("read")))
                .isInstanceOfSatisfying(
                        HeldWaypoints.class,
                        held -> assertThat(held.waypoints()).isEqualTo(HALF));
        assertThat(client.ask(new StartWaypoints("start", "long", 0))).isInstanceOf(Ack.class);
    }

    private void untilPassed(int waypoints) {
        Await.until(waypoints + " waypoints are passed", WAIT_S, () -> next() >= waypoints);
    }

    private int next() {
        return client.last(Progress.class).map(Progress::nextIndex).orElse(0);
    }

    private void arrives() {
        Await.until(
                "it is at the end",
                WAIT_S,
                () -> client.last(Progress.class).filter(Progress::completed).isPresent());
        assertThat(boat.mission().visited()).isEqualTo(places(HALF));
    }

    private static List<List<Double>> places(List<Waypoint> waypoints) {
        return waypoints.stream()
                .map(place -> List.of(degrees(place.latDeg()), degrees(place.lonDeg())))
                .toList();
    }

    private static double degrees(double exact) {
        return Math.round(exact * 1e7) / 1e7;
    }

    @Test
    void isDrivenToItsEndAndEachLocationOnce() {
        client.close();
        try (GatewayWorld world = new GatewayWorld(folder)) {
            world.connect(boat.address() + "/5");
            world.untilReady("mav5");
            List<GeoPoint> path = PATH.stream()
                    .map(place -> GeoPoint.of(place.latDeg(), place.lonDeg()))
                    .toList();
            world.tell("mav5", proxy -> proxy.commands().submit(FollowPath.of("long", 1, 1, path, Priority.MEDIUM)));

            Await.until(
                    "it is at the end",
                    WAIT_S,
                    () -> world.has(
                            FleetEvent.CommandCompleted.class,
                            done -> done.command().commandId().equals("long")));
            assertThat(world.faults).isEmpty();
        }

        assertThat(boat.mission().visited()).isEqualTo(places(PATH));
        // the vehicle's time runs 150 times as fast as that in which parts are sent: a busy machine is late
        boolean quiet = Boolean.getBoolean("crw.vehicleMissions");
        assertThat(boat.mission().stops()).isLessThan(quiet ? 1 : 100);
        assertThat(boat.mission().uploads()).isEqualTo(1);
        assertThat(boat.armings()).isEqualTo(1);
        // a busy machine sends a part in several rounds of the vehicle, each of which changes the leg under way
        List<Integer> begunAnew = boat.restarts().stream().distinct().toList();
        assertThat(begunAnew).as("legs that it began anew").hasSizeLessThan(60);
    }

    @Test
    void isHeldWholeByAVehicleThatHasRoomForItAlsoAfterABaseThatDied() {
        boat.mission().room(HALF.size() + 10);
        start();
        untilPassed(300);
        client.close();
        int alone = boat.mission().visited().size();
        Await.until(
                "it drives on past where a part would end",
                WAIT_S,
                () -> boat.mission().visited().size() > Math.max(alone, MissionWindow.SLOTS + 50));

        client = new LinkClient(folder, boat.address() + "/5");
        assertThat(client.ask(new ReadBack("read again"))).isInstanceOf(HeldWaypoints.class);
        assertThat(client.ask(new StartWaypoints("start again", "long", next())))
                .isInstanceOf(Ack.class);

        arrives();
        assertThat(boat.mission().uploads()).isEqualTo(1);
        assertThat(boat.restarts()).as("changes of its mission under way").isEmpty();
        assertThat(boat.mission().stops()).isZero();
        assertThat(boat.armings()).isEqualTo(1);
    }

    /** Rows of 110 waypoints, so that it comes to a turn well before its part ends. */
    @Test
    void partsAreSentAtTurnsWhereItIsSlowInAnyCase() {
        List<Waypoint> rows = IntStream.range(0, LOCATIONS / 2)
                .mapToObj(i -> new Waypoint(
                        45.7 + (i / ROW % 2 == 0 ? i % ROW : ROW - 1 - i % ROW) * 1e-4,
                        10.72 + Math.floorDiv(i, ROW) * 2e-4,
                        1))
                .toList();
        assertThat(client.ask(new UploadWaypoints("upload", "rows", rows))).isInstanceOf(Ack.class);
        assertThat(client.ask(new ReadBack("read"))).isInstanceOf(HeldWaypoints.class);
        assertThat(client.ask(new StartWaypoints("start", "rows", 0))).isInstanceOf(Ack.class);
        Await.until(
                "it is at the end",
                WAIT_S,
                () -> client.last(Progress.class).filter(Progress::completed).isPresent());

        assertThat(boat.mission().visited()).isEqualTo(places(rows));
        // its time runs 150 times as fast as that in which parts are sent: on a busy machine some come late
        List<Integer> changed = boat.restarts().stream().distinct().toList();
        List<Integer> afterATurn = changed.stream()
                .filter(item -> (item % MissionWindow.SLOTS - BEFORE_ITS_FIRST) % ROW < NEAR_TURN)
                .toList();
        assertThat(afterATurn).as("of %s", changed).hasSizeGreaterThanOrEqualTo((changed.size() + 1) / 2);
    }

    @Test
    void waitsAtTheEndOfItsPartWhileNothingComesThrough() {
        start();
        untilPassed(20);
        boat.reports().silent(true);
        Await.untilStill("it waits", 3, () -> boat.mission().visited().size());
        assertThat(boat.mission().visited()).hasSizeBetween(590, 900);

        boat.reports().silent(false);

        arrives();
        assertThat(client.said("mav5 says: Auto mission changed", Priority.HIGH))
                .isEmpty();
        assertThat(client.said("mav5 says: Auto mission changed", Priority.LOW)).isNotEmpty();
        assertThat(boat.mission().stops()).isPositive();
    }

    @Test
    void goesOnAfterABaseThatDiedWhereTheVehicleIs() {
        start();
        untilPassed(300);
        client.close();
        Await.untilStill(
                "it waits at the end of its part",
                3,
                () -> boat.mission().visited().size());
        int alone = boat.mission().visited().size();
        assertThat(alone).isBetween(300, HALF.size() - 1);

        client = new LinkClient(folder, boat.address() + "/5");
        assertThat(client.ask(new ReadBack("read again")))
                .isInstanceOfSatisfying(
                        HeldWaypoints.class,
                        held -> assertThat(held.waypoints()).isEqualTo(HALF));
        assertThat(next()).isGreaterThanOrEqualTo(alone - 1);
        assertThat(client.ask(new StartWaypoints("start again", "long", next())))
                .isInstanceOf(Ack.class);

        arrives();
        // one that has come to the end of its part is sent the part from there on
        assertThat(boat.mission().uploads()).isBetween(1, 2);
        assertThat(boat.armings()).isEqualTo(1);
    }

    @Test
    void startInTheMidstBringsThePartThere() throws Exception {
        end();
        launch(PATH.get(1_949));
        assertThat(client.ask(new UploadWaypoints("upload", "long", PATH))).isInstanceOf(Ack.class);
        assertThat(client.ask(new ReadBack("read"))).isInstanceOf(HeldWaypoints.class);

        assertThat(client.ask(new StartWaypoints("start", "long", 1_950))).isInstanceOf(Ack.class);

        Await.until(
                "it is at the end",
                WAIT_S,
                () -> client.last(Progress.class).filter(Progress::completed).isPresent());
        assertThat(boat.mission().visited()).hasSize(50);
    }

    @Test
    void shorterListReplacesItWhole() {
        start();
        untilPassed(300);
        List<Waypoint> other = List.of(PATH.get(0), PATH.get(1), PATH.get(2));

        assertThat(client.ask(new UploadWaypoints("upload other", "other", other)))
                .isInstanceOf(Ack.class);
        assertThat(client.ask(new ReadBack("read other")))
                .isInstanceOfSatisfying(
                        HeldWaypoints.class,
                        held -> assertThat(held.waypoints()).isEqualTo(other));
        assertThat(boat.mission().uploads()).isEqualTo(2);
    }

    @Test
    void partThatItRefusesIsAnAlarmAndTriedAgain() {
        start();
        boat.mission().refuse(true);

        client.untilAlarm("vehicle 5 has not taken the next part of its path, and waits where its part ends: ");
        boat.mission().refuse(false);

        arrives();
    }
}
