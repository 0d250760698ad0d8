package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.sami.boat.link.BoatMode;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.status.LinkState;
import org.sami.mavlink.testing.SmallBoat;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/** Each fault of a vehicle, its link or its base in each phase of a path: nothing is done twice, nothing moves unasked, and the operator hears of it. */
@Tag("long")
@Timeout(900)
class VehicleFaultMatrixTest {
    private static final double TIMES = 8;
    private static final long TOLD_MS = 4_000;
    private static final double NEAR_M = 3;
    private static final GeoPoint START = GeoPoint.of(45.7, 10.72);
    private static final List<GeoPoint> PATH =
            List.of(GeoPoint.of(45.7003, 10.72), GeoPoint.of(45.7003, 10.7204), GeoPoint.of(45.7, 10.7204));
    private static final int ANSWERS_UNTIL_BEGUN = 2; // how many items it has, and the first item that it wants
    private static final int ANSWERS_UNTIL_HALF = 5;
    private static final int ANSWERS_UNTIL_UPLOADED =
            8; // home, speed, three waypoints, the item that keeps the place; not read back

    private enum Fault {
        LINK_CUT,
        VEHICLE_STANDS_STILL,
        REBOOT,
        BASE_KILLED
    }

    private enum Phase {
        BEFORE_CONNECTING,
        CONNECTING,
        UPLOAD_BEGUN,
        UPLOAD_HALF,
        UPLOADED,
        STARTING,
        UNDER_WAY,
        HALF_WAY,
        BY_HAND,
        STOPPED;

        boolean isConnected() {
            return this != BEFORE_CONNECTING && this != CONNECTING;
        }

        boolean moves() {
            return this == UNDER_WAY || this == HALF_WAY || this == BY_HAND;
        }

        /** Whether a path was ordered before the fault. */
        boolean isOrdered() {
            return isConnected() && this != BY_HAND;
        }
    }

    @TempDir
    private Path folder;

    private SmallBoat boat;
    private GatewayWorld world;
    private Optional<String> list = Optional.empty(); // that the vehicle was given before its base died

    @BeforeEach
    void launch() throws Exception {
        boat = new SmallBoat(7, START.latDeg(), START.lonDeg(), TIMES);
        world = new GatewayWorld(folder);
    }

    @AfterEach
    void end() throws Exception {
        boat.faults().frozen(false);
        world.close();
        boat.close();
        assertThat(world.faults).isEmpty();
    }

    private static Stream<Arguments> cases() {
        return Arrays.stream(Fault.values())
                .flatMap(fault -> Arrays.stream(Phase.values()).map(phase -> Arguments.of(fault, phase)));
    }

    @ParameterizedTest(name = "{0} while {1}")
    @MethodSource("cases")
    void nothingIsDoneTwiceOrUnaskedAndItIsTold(Fault fault, Phase phase) throws Exception {
        reach(phase);
        int armed = boat.armings();
        double movedM = boat.movedM();

        begin(fault, phase);

        if (phase.isConnected()) {
            isTold(fault);
        }
        if (!phase.moves()) {
            assertThat(boat.movedM()).isEqualTo(movedM);
        }
        boat.faults().answersAboutMissions(Integer.MAX_VALUE);
        boat.faults().ignoresOrders(false);
        end(fault);
        if (phase == Phase.BY_HAND) {
            comesToRest(fault);
            return;
        }
        world.untilReady("mav7");
        if (phase == Phase.STOPPED) {
            world.until(
                    "it is stopped", "mav7", proxy -> proxy.status().mode().equals(Optional.of(BoatMode.FLEET_STOP)));
            world.tell("mav7", BoatProxy::fleetRelease);
        }
        if (fault == Fault.REBOOT && phase.isConnected()) {
            movedM = boat.movedM();
            assertThat(boat.isArmed()).isFalse();
            world.tell("mav7", BoatProxy::confirmRestart);
        }
        if (fault == Fault.BASE_KILLED || !phase.isOrdered()) {
            list.ifPresent(held -> world.tell("mav7", proxy -> proxy.commands().knownList(held)));
            submit();
        }
        completes();
        boolean again = armed > 0 && (fault == Fault.REBOOT || phase == Phase.STOPPED);
        assertThat(boat.armings()).isEqualTo(again ? 2 : 1);
        assertThat(boat.mission().uploads()).isLessThanOrEqualTo(phase.isConnected() && armed == 0 ? 2 : 1);
        assertThat(boat.mission().visited()).doesNotHaveDuplicates();
        PATH.forEach(point ->
                assertThat(boat.nearestM(point.latDeg(), point.lonDeg())).isLessThan(NEAR_M));
    }

    private void reach(Phase phase) {
        if (phase == Phase.BEFORE_CONNECTING) {
            return;
        }
        world.connect(boat.address() + "/7");
        if (phase == Phase.CONNECTING) {
            return;
        }
        world.untilReady("mav7");
        switch (phase) {
            case UPLOAD_BEGUN -> uploads(ANSWERS_UNTIL_BEGUN);
            case UPLOAD_HALF -> uploads(ANSWERS_UNTIL_HALF);
            case UPLOADED -> {
                uploads(ANSWERS_UNTIL_UPLOADED);
                assertThat(boat.mission().uploads()).isEqualTo(1);
            }
            case STARTING -> {
                boat.faults().ignoresOrders(true);
                submit();
                Await.until(
                        "it is ordered to set off",
                        GatewayWorld.WAIT_S,
                        () -> boat.faults().ignoredOrders() > 0);
            }
            case UNDER_WAY -> setsOff();
            case HALF_WAY -> {
                setsOff();
                Await.until(
                        "a point is visited",
                        GatewayWorld.WAIT_S,
                        () -> boat.mission().visited().size() == 1);
            }
            case BY_HAND -> {
                world.tell("mav7", proxy -> proxy.teleoperate(0.5, 0));
                Await.until("it moves", GatewayWorld.WAIT_S, () -> boat.movedM() > 1);
            }
            case STOPPED -> {
                setsOff();
                world.tell("mav7", BoatProxy::fleetStop);
                world.until(
                        "it is stopped",
                        "mav7",
                        proxy -> proxy.status().mode().equals(Optional.of(BoatMode.FLEET_STOP)));
            }
            default -> throw new IllegalStateException("no such phase: " + phase);
        }
    }

    private void uploads(int answers) {
        boat.faults().answersAboutMissions(answers);
        submit();
        Await.until(
                "the mission is on its way",
                GatewayWorld.WAIT_S,
                () -> boat.faults().answersLeft() == 0);
    }

    private void setsOff() {
        submit();
        world.until("it is under way", "mav7", proxy -> proxy.status().mode().equals(Optional.of(BoatMode.PATH)));
    }

    private void submit() {
        world.tell("mav7", proxy -> proxy.commands().submit(FollowPath.of("path", 1, 1, PATH, Priority.MEDIUM)));
    }

    private void begin(Fault fault, Phase phase) throws Exception {
        switch (fault) {
            case LINK_CUT -> boat.cut(true);
            case VEHICLE_STANDS_STILL -> boat.faults().frozen(true);
            case REBOOT -> boat.restart();
            case BASE_KILLED -> {
                list = phase.isConnected()
                        ? world.ask("mav7", proxy -> proxy.commands().heldListId())
                        : Optional.empty();
                boat.faults().deaf(true);
                world.close();
            }
        }
        if (phase == Phase.BEFORE_CONNECTING && fault != Fault.BASE_KILLED) {
            world.connect(boat.address() + "/7");
        }
    }

    private void isTold(Fault fault) {
        long beganMs = ProcessClock.ms();
        switch (fault) {
            case LINK_CUT, VEHICLE_STANDS_STILL ->
                Await.until(
                        "the link is lost",
                        GatewayWorld.WAIT_S,
                        () -> world.has(
                                FleetEvent.LinkChanged.class,
                                news -> news.status().link() == LinkState.LOST));
            case REBOOT ->
                Await.until(
                        "the restart is told",
                        GatewayWorld.WAIT_S,
                        () -> world.has(FleetEvent.Restarted.class, news -> true));
            case BASE_KILLED -> {
                return; // there is nobody to whom it could be told
            }
        }
        assertThat(ProcessClock.ms() - beganMs).isLessThanOrEqualTo(TOLD_MS);
    }

    private void end(Fault fault) throws Exception {
        switch (fault) {
            case LINK_CUT -> boat.cut(false);
            case VEHICLE_STANDS_STILL -> boat.faults().frozen(false);
            case REBOOT -> {
                // it is over
            }
            case BASE_KILLED -> {
                boat.faults().deaf(false);
                world = new GatewayWorld(folder, "base-2");
                world.connect(boat.address() + "/7");
            }
        }
    }

    /** Nobody steers it any longer: it is stopped, or the next base is told who has it. */
    private void comesToRest(Fault fault) {
        if (fault == Fault.BASE_KILLED) {
            Await.until(
                    "the next base is told that it is driven",
                    GatewayWorld.WAIT_S,
                    () -> world.alarms.stream().anyMatch(text -> text.startsWith("mav7 is taken by a pilot")));
            world.until("the next base has it in its fleet", "mav7", proxy -> true); // the alarm comes before
            world.tell("mav7", BoatProxy::fleetStop);
        }
        Await.until("it is disarmed", GatewayWorld.WAIT_S, () -> !boat.isArmed());
        assertThat(boat.armings()).isEqualTo(1);
    }

    private void completes() {
        Await.until(
                "the path is completed",
                GatewayWorld.WAIT_S,
                () -> world.has(FleetEvent.CommandCompleted.class, done -> true)
                        || world.has(FleetEvent.CommandFailed.class, failed -> {
                            throw new AssertionError(failed.reason());
                        }));
    }
}
