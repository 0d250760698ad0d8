package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.Ack;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.HoldPosition;
import org.sami.boat.link.Nack;
import org.sami.boat.link.NackReason;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.Telemetry;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.testing.Await;
import org.sami.mavlink.testing.SmallBoat;

/** Who takes a simulated vehicle before anything is ordered, while an order runs, or after one has failed. */
@Timeout(900)
class VehicleTakenTest {
    private static final int MANUAL = 0;
    private static final int HOLD = 4;
    private static final int LOITER = 5;
    private static final int AUTO = 10;
    private static final List<Waypoint> LIST =
            List.of(new Waypoint(45.71, 10.72, 1), new Waypoint(45.71, 10.73, 1), new Waypoint(45.72, 10.73, 2));

    @TempDir
    private Path folder;

    private SmallBoat boat;
    private LinkClient client;

    @BeforeEach
    void launch() throws Exception {
        boat = new SmallBoat(5, 45.7, 10.72, 1);
        client = new LinkClient(folder, boat.address() + "/5");
    }

    @AfterEach
    void end() throws Exception {
        client.close();
        boat.close();
    }

    private static UploadWaypoints upload(String list) {
        return new UploadWaypoints("upload " + list, list, LIST);
    }

    private void drive() {
        assertThat(client.ask(upload("first"))).isInstanceOf(Ack.class);
        assertThat(client.ask(new StartWaypoints("start", "first", 0))).isInstanceOf(Ack.class);
        assertThat(boat.mode()).isEqualTo(AUTO);
    }

    @Test
    void vehicleThatAPilotTakesWhileItsMissionIsSentDoesNotSetOff() {
        boat.faults().ignoresMissions(true);
        assertThat(client.ask(upload("first"))).isInstanceOf(Ack.class);
        StartWaypoints start = new StartWaypoints("start", "first", 0);
        client.say(start);

        boat.takenByPilot(MANUAL, true);

        assertThat(client.answerTo(start))
                .isInstanceOfSatisfying(
                        Nack.class, nack -> assertThat(nack.reason()).isEqualTo(NackReason.NOT_COMMANDER));
        Await.until("it is noticed that it is taken", client::isObserver);
        assertStaysAsMissionComes(MANUAL, true);
        assertThat(boat.orderedModes()).doesNotContain(AUTO);
    }

    @Test
    void boatThatAPilotDisarmsAsSoonAsAnOrderHasArmedItIsHis() {
        assertThat(client.ask(upload("first"))).isInstanceOf(Ack.class);
        boat.faults().ignoresSpeeds(true);
        StartWaypoints start = new StartWaypoints("start", "first", 0);
        client.say(start);
        Await.until(
                "it is seen to drive",
                () -> client.last(Telemetry.class).orElseThrow().mode() == BoatMode.PATH);

        boat.takenByPilot(AUTO, false);

        assertThat(client.answerTo(start))
                .isInstanceOfSatisfying(
                        Nack.class, nack -> assertThat(nack.reason()).isEqualTo(NackReason.NOT_COMMANDER));
        Await.until("it is noticed that it is taken", client::isObserver);
        assertThat(boat.isArmed()).isFalse();
    }

    private void assertStaysAsMissionComes(int mode, boolean armed) {
        int uploads = boat.mission().uploads();
        boat.faults().ignoresMissions(false);
        Await.until("it holds the mission", () -> boat.mission().uploads() > uploads);
        long before = client.count(Telemetry.class);
        Await.until("it has said where it is", () -> client.count(Telemetry.class) > before + 3);
        assertThat(boat.mode()).isEqualTo(mode);
        assertThat(boat.isArmed()).isEqualTo(armed);
    }

    @Test
    void boatThatAPilotDisarmsWhileItsMissionIsSentIsNotArmedAgain() {
        assertThat(client.ask(new HoldPosition("hold"))).isInstanceOf(Ack.class);
        boat.faults().ignoresMissions(true);
        assertThat(client.ask(upload("first"))).isInstanceOf(Ack.class);
        client.say(new StartWaypoints("start", "first", 0));

        boat.takenByPilot(LOITER, false);

        Await.until("it is noticed that it is taken", client::isObserver);
        assertStaysAsMissionComes(LOITER, false);
    }

    @Test
    void vehicleThatSomebodyStartsBeforeAnythingIsOrderedIsTheirs() {
        boat.takenByPilot(MANUAL, true);

        Await.until("it is noticed that it is taken", client::isObserver);
        assertThat(client.ask(upload("refused")))
                .isInstanceOfSatisfying(
                        Nack.class, nack -> assertThat(nack.reason()).isEqualTo(NackReason.NOT_COMMANDER));
        client.takeCommand();
        drive();
    }

    @Test
    void vehicleThatSomebodyArmsInHoldBeforeAnythingIsOrderedSetsOffWhenItIsOrderedTo() {
        boat.takenByPilot(HOLD, true);
        long before = client.count(Telemetry.class);
        Await.until("it has said where it is", () -> client.count(Telemetry.class) > before + 3);

        assertThat(client.isObserver()).isFalse();
        drive();
    }

    @Test
    void vehicleThatSomebodyStartsAfterAnOrderHasFailedIsTheirs() {
        assertThat(client.ask(upload("first"))).isInstanceOf(Ack.class);
        boat.faults().refuseMode(AUTO);
        assertThat(client.ask(new StartWaypoints("start", "first", 0))).isInstanceOf(Nack.class);

        boat.takenByPilot(MANUAL, true);

        Await.until("it is noticed that it is taken", client::isObserver);
        assertThat(boat.mode()).isEqualTo(MANUAL);
    }

    @Test
    void vehicleThatAPilotTakesWhileAnOrderRunsIsNotDisarmedAsThatFails() {
        assertThat(client.ask(upload("first"))).isInstanceOf(Ack.class);
        boat.faults().ignoresSpeeds(true);
        StartWaypoints start = new StartWaypoints("start", "first", 0);
        client.say(start);
        Await.until("it drives", () -> boat.isArmed() && boat.mode() == AUTO);

        boat.takenByPilot(MANUAL, true);

        assertThat(client.answerTo(start)).isInstanceOf(Nack.class);
        assertThat(boat.isArmed()).isTrue();
        assertThat(boat.mode()).isEqualTo(MANUAL);
    }
}
