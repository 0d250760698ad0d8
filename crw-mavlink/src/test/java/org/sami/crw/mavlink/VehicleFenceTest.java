package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.Ack;
import org.sami.boat.link.HoldPosition;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.mavlink.mission.MissionItem;
import org.sami.mavlink.testing.SmallBoat;
import org.sami.spn.value.GeoArea;

/** The area in which boats may go as the fence of a vehicle. */
@Timeout(900)
class VehicleFenceTest {
    private static final GeoArea WATER = SquareArea.of(45.69, 10.71, 0.02);
    private static final GeoArea ROCK = SquareArea.of(45.701, 10.721, 0.001);
    private static final List<MissionItem> FENCE = FenceItems.of(Optional.of(WATER), List.of(ROCK));

    private static final long LONG_MS = 15_000;

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

    private void isInForce() {
        Await.until("its fence is in force", () -> boat.parameter("FENCE_ENABLE") == 1);
    }

    @Test
    void areasOfTheSessionAreItsFence() {
        client.keepTo(Optional.of(WATER), List.of(ROCK));

        isInForce();
        assertThat(FenceItems.isHeld(FENCE, boat.fence().items())).isTrue();
        assertThat(boat.fence().items())
                .extracting(MissionItem::command)
                .containsExactly(5001, 5001, 5001, 5001, 5002, 5002, 5002, 5002);
        assertThat(boat.parameter("FENCE_TYPE")).isEqualTo(4);
        assertThat(boat.parameter("FENCE_ACTION")).isEqualTo(2);
    }

    @Test
    void fenceThatItHoldsAlreadyIsNotSent() {
        boat.fence().put(FENCE);

        client.keepTo(Optional.of(WATER), List.of(ROCK));

        isInForce();
        assertThat(boat.fence().uploads()).isZero();
    }

    @Test
    void fenceOfItsOwnerIsReplacedWithAWord() {
        boat.fence().put(FenceItems.of(Optional.of(ROCK), List.of()));

        client.keepTo(Optional.of(WATER), List.of(ROCK));

        client.untilAlarm("vehicle 5 held a fence of its own with 4 corners");
        isInForce();
        assertThat(FenceItems.isHeld(FENCE, boat.fence().items())).isTrue();
    }

    @Test
    void withoutAreasItsFenceIsItsOwners() {
        List<MissionItem> own = FenceItems.of(Optional.of(ROCK), List.of());
        boat.fence().put(own);

        client.keepTo(Optional.empty(), List.of());
        assertThat(client.ask(new HoldPosition("hold"))).isInstanceOf(Ack.class); // time passes

        assertThat(boat.fence().items()).isEqualTo(own);
        assertThat(boat.fence().uploads()).isZero();
        assertThat(boat.parameter("FENCE_ENABLE")).isZero();
    }

    @Test
    void areasThatTheSessionGivesUpAreTakenAway() {
        client.keepTo(Optional.of(WATER), List.of(ROCK));
        isInForce();

        client.keepTo(Optional.empty(), List.of());

        Await.until("it is gone", () -> boat.fence().items().isEmpty());
        assertThat(boat.parameter("FENCE_ENABLE")).isZero();
    }

    @Test
    void cornerThatItRefusesIsNamed() {
        boat.fence().refuseCorner(6);

        client.keepTo(Optional.of(WATER), List.of(ROCK));

        client.untilAlarm("at item 6 (nav fence polygon vertex exclusion at 45.7020000, 10.7220000): invalid");
        assertThat(boat.parameter("FENCE_ENABLE")).isZero();
    }

    @Test
    void breachIsAnAlarm() {
        client.keepTo(Optional.of(WATER), List.of(ROCK));
        isInForce();

        boat.fence().outside(true);

        client.untilAlarm("mav5 says that it is outside of its own fence");
    }

    @Test
    void fenceThatAnotherStationSwitchesOffIsAnAlarmAndSetAgain() {
        client.keepTo(Optional.of(WATER), List.of(ROCK));
        isInForce();

        Await.until("it is told", () -> {
            if (boat.parameter("FENCE_ENABLE") == 1) { // the base may not have read before that it is
                boat.setByAnother("FENCE_ENABLE", 0);
            }
            return client.hasAlarm("the fence of vehicle 5 was changed by somebody else (FENCE_ENABLE 0, before 1)");
        });

        isInForce();
        assertThat(FenceItems.isHeld(FENCE, boat.fence().items())).isTrue();
    }

    /** A fence in force keeps the kinds that it had when it was switched on, whatever FENCE_TYPE is set to. */
    @Test
    void areasAreInForceWhereTheOwnersFenceWasSwitchedOnBeforeWithoutPolygons() {
        boat.parameter("FENCE_TYPE", 2);
        boat.parameter("FENCE_ENABLE", 1);
        Await.until(
                "the owner's is on", () -> boat.fence().isOn() && boat.fence().kinds() == 2);

        client.keepTo(Optional.of(WATER), List.of(ROCK));
        isInForce();

        Await.until("with polygons", () -> (boat.fence().kinds() & 4) != 0);
    }

    /** As ArduPilot's DO_FENCE_ENABLE and its switch do: no parameter tells it. */
    @Test
    void fenceThatIsSwitchedOffWithoutAParameterIsAnAlarmAndPutInForceAgain() {
        client.keepTo(Optional.of(WATER), List.of(ROCK));
        isInForce();

        Await.until("it is told", () -> {
            if (boat.fence().isOn()) { // the base may not have read before that it is
                boat.fence().switched(false);
            }
            return client.hasAlarm(
                    "the fence of vehicle 5 was changed by somebody else (switched off by a command or by"
                            + " a switch of its radio control); that of this session is set again");
        });

        Await.until("it is in force again", () -> boat.fence().isOn());
        assertThat(boat.parameter("FENCE_ENABLE")).isEqualTo(1);
        assertThat(client.hasAlarm("does not keep to the fence")).isFalse();
    }

    /** With FENCE_AUTOENABLE it does so as it is armed and disarmed, takes off and lands. */
    @Test
    void vehicleThatSwitchesItsFenceByItselfIsLeftToDoSo() {
        boat.parameter("FENCE_AUTOENABLE", 3);
        client.keepTo(Optional.of(WATER), List.of(ROCK));
        isInForce();
        Await.until("it is on", () -> boat.fence().isOn());
        Await.holds("it has said so again and again", 2, () -> boat.fence().isOn());

        boat.fence().switched(false);

        Await.holds("it stays off", 5, () -> !boat.fence().isOn());
        assertThat(client.hasAlarm("changed by somebody else")).isFalse();
    }

    @Test
    void fenceThatAnotherStationClearsIsFoundAsABaseComes() {
        client.keepTo(Optional.of(WATER), List.of(ROCK));
        isInForce();
        long readMs = ProcessClock.ms();
        Await.until("it is a while ago that it was read", () -> ProcessClock.ms() - readMs > LONG_MS);

        boat.fence().put(List.of());
        client.reconnect();

        client.untilAlarm("the fence of vehicle 5 was changed by somebody else (FENCE_TOTAL 0, before 8)");
        Await.until(
                "it has it again", () -> FenceItems.isHeld(FENCE, boat.fence().items()));
    }

    @Test
    void fenceOfAnEarlierSessionIsReplacedWithoutAWord() {
        client.keepTo(Optional.of(WATER), List.of(ROCK));
        isInForce();
        client.close();

        client = new LinkClient(folder, boat.address() + "/5");
        client.keepTo(Optional.of(WATER), List.of());

        Await.until("its fence is another", () -> boat.fence().items().size() == 4);
        assertThat(client.hasAlarm("a fence of its own")).isFalse();
    }
}
