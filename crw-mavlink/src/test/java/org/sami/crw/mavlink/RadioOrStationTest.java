package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.BoatMode;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.mavlink.address.AddressText;
import org.sami.mavlink.base.MavlinkBase;
import org.sami.mavlink.testing.SmallBoat;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/** Whoever takes or starts a vehicle is named: the pilot by what the radio control does, a ground station by its id. */
@Tag("long")
@Timeout(120)
class RadioOrStationTest {
    private static final String BOAT = "mav7";
    private static final int MANUAL = 0;
    private static final int HOLD = 4;
    private static final int GUIDED = 15;
    private static final int STEERING = 1;
    private static final int SWITCH = 8;
    private static final int LOW_US = 1_000;
    private static final int HIGH_US = 2_000;

    @TempDir
    private Path folder;

    private SmallBoat boat;
    private GatewayWorld world;
    private int modes; // that its switch has

    @BeforeEach
    void launch() throws Exception {
        boat = new SmallBoat(7, 45.7, 10.72, 20);
        boat.parameter("RCMAP_ROLL", STEERING);
        boat.parameter("MODE_CH", SWITCH);
        List.of(HOLD, HOLD, HOLD, HOLD, HOLD, MANUAL).forEach(this::addMode);
        world = new GatewayWorld(folder);
    }

    private void addMode(int number) {
        boat.parameter("MODE" + ++modes, number);
    }

    @AfterEach
    void end() throws Exception {
        world.close();
        boat.close();
        assertThat(world.faults).isEmpty();
    }

    private void connect() {
        world.connect(boat.address());
        world.untilReady(BOAT);
        Await.until("it was asked for all modes of its switch", GatewayWorld.WAIT_S, () -> boat.wasAsked("MODE6"));
    }

    private void sail() {
        GeoPoint there = GeoPoint.of(45.71, 10.72);
        world.tell(BOAT, proxy -> proxy.commands().submit(FollowPath.of("p", 1, 1, List.of(there), Priority.MEDIUM)));
        world.until("it is under way", BOAT, proxy -> proxy.status().mode().equals(Optional.of(BoatMode.PATH)));
    }

    private void untilSaid(String words) {
        Await.until(words, GatewayWorld.WAIT_S, () -> world.alarms.stream().anyMatch(text -> text.contains(words)));
    }

    @Test
    void pilotWhoMovesTheModeSwitchIsNamed() {
        boat.radio().move(SWITCH, LOW_US);
        connect();
        sail();

        boat.radio().move(SWITCH, HIGH_US);
        boat.takenByPilot(MANUAL, true);

        untilSaid("a pilot's radio control (MANUAL)");
    }

    @Test
    void stationIsNamedWhereTheModeSwitchStandsElsewhere() throws Exception {
        boat.radio().move(SWITCH, LOW_US);
        connect();
        sail();
        try (MavlinkBase other = other()) {
            other.setMode(other.vehicles().join().get(0).id(), "MANUAL").join();

            untilSaid("controlled by ground station 255 (not this base, which has the same id) (MANUAL)");
            world.until("it is somebody else's", BOAT, proxy -> !proxy.isCommanding());
            world.tell(BOAT, proxy -> proxy.handOver().takeCommand());
            Await.until("it goes on", GatewayWorld.WAIT_S, () -> boat.isArmed() && boat.mode() == GUIDED);
        }
    }

    /** A station on the vehicle's second link, heard there and passed on. */
    private MavlinkBase other() {
        MavlinkBase other = new MavlinkBase(List.of(AddressText.parse(boat.secondAddress())), ProcessClock::ms);
        Await.until(
                "it is heard",
                GatewayWorld.WAIT_S,
                () -> !other.vehicles().join().isEmpty());
        return other;
    }

    @Test
    void stationThatIsHeardIsNamedWhereNoRadioControlIsReceived() {
        boat.radio().none();
        connect();
        sail();
        try (MavlinkBase other = other()) {
            other.setMode(other.vehicles().join().get(0).id(), "MANUAL").join();

            untilSaid("by ground station 255 (not this base, which has the same id) (MANUAL)");
            world.until("it is somebody else's", BOAT, proxy -> !proxy.isCommanding());
            world.tell(BOAT, proxy -> proxy.handOver().takeCommand());
            Await.until("it goes on", GatewayWorld.WAIT_S, () -> boat.isArmed() && boat.mode() == GUIDED);
        }
    }

    @Test
    void stationThatIsNotHeardIsSaidToBeOneWhereNoRadioControlIsReceived() {
        boat.radio().none();
        connect();
        sail();

        boat.takenByPilot(MANUAL, true);

        untilSaid("a ground station that is not heard here (MANUAL)");
    }

    @Test
    void stationThatTheVehicleObeysOnThisLinkIsNamed() {
        connect();
        sail();

        boat.obeys(252, MANUAL, true);

        untilSaid("ground station 252 (MANUAL)");
    }

    @Test
    void pilotWhoStartsAStoppedBoatByTheStickIsNamedAlsoAsItMoves() {
        boat.radio().move(SWITCH, LOW_US);
        connect();
        world.tell(BOAT, BoatProxy::fleetStop);
        world.until("it is stopped", BOAT, proxy -> proxy.status().mode().equals(Optional.of(BoatMode.FLEET_STOP)));

        boat.radio().move(STEERING, HIGH_US);
        boat.takenByPilot(HOLD, true);
        Await.until("it is told", GatewayWorld.WAIT_S, () -> hasCritical("a pilot's radio control (HOLD)"));
        boat.reports().claimSpeed(1.2);

        Await.until(
                "that it moves, too",
                GatewayWorld.WAIT_S,
                () -> hasCritical("m/s, armed by a pilot's radio control (HOLD)"));
    }

    private boolean hasCritical(String words) {
        return world.said.stream()
                .anyMatch(alarm ->
                        alarm.priority() == Priority.CRITICAL && alarm.text().contains(words));
    }

    @Test
    void bothAreNamedWhereNothingDecides() {
        connect();
        sail();

        boat.takenByPilot(MANUAL, true);

        untilSaid(BOAT + " is taken by a pilot or another ground station (MANUAL)");
    }

    @Test
    void pilotWhoOnlyMovesAnotherSwitchHasNotTakenIt() {
        connect();
        sail();

        boat.says(6, "RC7: CameraTrigger HIGH");
        boat.takenByPilot(MANUAL, true);

        untilSaid(BOAT + " is taken by a pilot or another ground station (MANUAL)");
    }

    @Test
    void baseOnTwoLinksIsNoOtherStationOfItself() {
        boat.radio().none();
        world.connect(boat.address());
        world.connect(boat.secondAddress());
        world.untilReady(BOAT);
        sail();

        boat.takenByPilot(MANUAL, true);

        untilSaid("a ground station that is not heard here (MANUAL)");
    }
}
