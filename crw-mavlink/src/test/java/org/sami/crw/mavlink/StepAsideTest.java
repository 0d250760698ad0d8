package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.Ack;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.HoldPosition;
import org.sami.boat.link.NearbyBoat;
import org.sami.boat.link.Progress;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.StopMotors;
import org.sami.boat.link.Telemetry;
import org.sami.boat.link.Traffic;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.mavlink.testing.SmallBoat;

/** What a vehicle does when its base says that another boat lies in its way; how near real ones come, {@link ArduPilotGivingWayTest} says. */
@Timeout(900)
class StepAsideTest {
    private static final int MANUAL = 0;
    private static final int HOLD = 4;
    private static final int LOITER = 5;
    private static final int AUTO = 10;
    private static final int GUIDED = 15;
    private static final double WAIT_S = 120;
    private static final Waypoint START = new Waypoint(45.7, 10.72, 1);
    private static final LocalFrame PLANE = new LocalFrame(START.latDeg(), START.lonDeg());
    private static final List<Waypoint> LIST = List.of(east(4_000), east(8_000)); // it says that it heads east

    @TempDir
    private Path folder;

    private SmallBoat boat;
    private LinkClient client;

    @BeforeEach
    void driveEast() throws Exception {
        boat = new SmallBoat(5, START.latDeg(), START.lonDeg(), 1);
        client = new LinkClient(folder, boat.address() + "/5");
        assertThat(client.ask(new UploadWaypoints("upload", "list", LIST))).isInstanceOf(Ack.class);
        assertThat(client.ask(new StartWaypoints("start", "list", 0))).isInstanceOf(Ack.class);
        assertThat(boat.mode()).isEqualTo(AUTO);
    }

    @AfterEach
    void end() throws Exception {
        client.close();
        boat.close();
    }

    private static Waypoint east(double metres) {
        return new Waypoint(PLANE.latDeg(metres, 0), PLANE.lonDeg(metres, 0), 1);
    }

    /** Another boat lies 6 m ahead of where this one was last. */
    private void aBoatLiesAhead() {
        Telemetry at = client.last(Telemetry.class).orElseThrow();
        double eastM = PLANE.eastM(at.latDeg(), at.lonDeg());
        Waypoint there = east(eastM + 6);
        client.say(new Traffic(
                List.of(new NearbyBoat("anna", there.latDeg(), there.lonDeg(), 0, 0, BoatMode.STOPPED, 0))));
    }

    /** Says again and again that the boat is there. */
    private void whileABoatLiesAhead(String words, BooleanSupplier until) {
        Await.until(words, WAIT_S, () -> {
            aBoatLiesAhead();
            return until.getAsBoolean();
        });
    }

    private String givesWayTo() {
        return client.last(Telemetry.class).map(Telemetry::givesWayTo).orElse("");
    }

    private void stepsAside() {
        whileABoatLiesAhead(
                "it is steered", () -> boat.mode() == GUIDED && !boat.courses().isEmpty());
    }

    @Test
    void isSteeredAroundABoatAndThenGoesOnAlongItsMission() {
        stepsAside();
        whileABoatLiesAhead("it is still its base's", () -> boat.courses().size() > 5);
        whileABoatLiesAhead("it says to whom it gives way", () -> givesWayTo().equals("anna"));
        assertThat(client.last(Telemetry.class).orElseThrow().mode()).isEqualTo(BoatMode.PATH);

        Await.until("it goes on", WAIT_S, () -> boat.mode() == AUTO); // nothing is said of the other any longer

        assertThat(client.isObserver()).isFalse();
        Await.until("it gives way to nobody", WAIT_S, () -> givesWayTo().isEmpty());
        assertThat(boat.mission().uploads()).isEqualTo(1);
        assertThat(client.last(Progress.class).orElseThrow().nextIndex()).isZero();
    }

    @Test
    void givesWayAgainAfterItHasGoneOn() {
        stepsAside();
        Await.until("it goes on", WAIT_S, () -> boat.mode() == AUTO);
        int before = boat.courses().size();

        whileABoatLiesAhead(
                "it is steered again",
                () -> boat.mode() == GUIDED && boat.courses().size() > before);

        assertThat(client.isObserver()).isFalse();
    }

    @Test
    void isNotSteeredAnyLongerOnceAPilotHasTakenIt() {
        stepsAside();
        whileABoatLiesAhead(
                "it has been aside for a while", () -> boat.courses().size() > 10);

        boat.takenByPilot(MANUAL, true);
        whileABoatLiesAhead("it is taken", client::isObserver);
        boat.takenByPilot(GUIDED, true); // the pilot's own target
        int then = boat.courses().size();
        long said = client.count(Telemetry.class);
        whileABoatLiesAhead("it has reported for a while", () -> client.count(Telemetry.class) > said + 20);

        assertThat(boat.courses()).hasSize(then);
        assertThat(boat.mode()).isEqualTo(GUIDED);
    }

    @Test
    void stopsAndHoldsWhenItIsOrderedToWhileItIsAside() {
        stepsAside();

        assertThat(client.ask(new HoldPosition("hold"))).isInstanceOf(Ack.class);
        assertThat(boat.mode()).isEqualTo(LOITER);
        assertThat(client.ask(new StopMotors("stop"))).isInstanceOf(Ack.class);
        assertThat(boat.mode()).isEqualTo(HOLD);
        assertThat(boat.isArmed()).isFalse();

        int then = boat.courses().size();
        long said = client.count(Telemetry.class);
        whileABoatLiesAhead("it has reported for a while", () -> client.count(Telemetry.class) > said + 20);
        assertThat(boat.courses()).hasSize(then);
        assertThat(boat.mode()).isEqualTo(HOLD);
        assertThat(client.isObserver()).isFalse();
    }

    /** The other one is to come to where it lies at the end of its path. */
    @Test
    void makesRoomAtTheEndOfItsPathAndIsStillItsBases() throws Exception {
        Waypoint end = east(8);
        assertThat(client.ask(new UploadWaypoints("short", "short", List.of(east(4), end))))
                .isInstanceOf(Ack.class);
        assertThat(client.ask(new StartWaypoints("go", "short", 0))).isInstanceOf(Ack.class);
        Await.until(
                "it is at the end of its path",
                WAIT_S,
                () -> client.last(Progress.class)
                        .filter(progress -> progress.listId().equals("short") && progress.completed())
                        .isPresent());

        Waypoint from = east(20);
        Await.until("it has made room", WAIT_S, () -> {
            client.say(new Traffic(List.of(new NearbyBoat(
                    "anna", from.latDeg(), from.lonDeg(), -1.57, 0.5, BoatMode.PATH, 0, end.latDeg(), end.lonDeg()))));
            return boat.mode() == GUIDED && boat.metresTo(end.latDeg(), end.lonDeg()) > 5;
        });

        assertThat(client.last(Telemetry.class).orElseThrow().mode()).isEqualTo(BoatMode.HOLD);
        assertThat(client.isObserver()).isFalse();
    }

    @Test
    void goesOnAlongItsMissionWhereItCannotBeSteered() {
        boat.faults().refuseMode(GUIDED);

        whileABoatLiesAhead("the operator knows", () -> client.hasAlarm("cannot give way to anna"));

        assertThat(boat.mode()).isEqualTo(AUTO);
        assertThat(client.isObserver()).isFalse();
    }
}
