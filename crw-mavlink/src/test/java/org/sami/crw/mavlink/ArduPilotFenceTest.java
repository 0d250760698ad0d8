package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.crw.fleet.RobotKind;
import org.sami.mavlink.address.AddressText;
import org.sami.mavlink.base.MavlinkBase;
import org.sami.mavlink.command.VehicleCommand;
import org.sami.mavlink.testing.ArduPilotBoats;
import org.sami.mavlink.vehicle.VehicleId;
import org.sami.spn.value.GeoArea;

/** The real firmware's fence, which another ground station switches off by a command: no parameter tells it. */
@Tag("long")
@Timeout(600)
class ArduPilotFenceTest {
    private static final int NUMBER = 104;
    private static final int SPEED = 5;
    private static final double WAIT_S = 300; // its parameters are sent when it has started
    private static final int SWITCH_FENCE = 207;
    private static final VehicleId ID = new VehicleId(NUMBER + 1, 1);
    private static final GeoArea WATER = SquareArea.of(45.69, 10.74, 0.02);
    private static final GeoArea ROCK = SquareArea.of(45.7005, 10.7485, 0.0005);

    @TempDir
    private Path work;

    private Optional<LinkClient> client = Optional.empty();
    private Optional<MavlinkBase> other = Optional.empty();
    private Optional<ArduPilotBoats> vehicles = Optional.empty();

    @AfterEach
    void end() throws Exception {
        client.ifPresent(LinkClient::close);
        other.ifPresent(MavlinkBase::close);
        if (vehicles.isPresent()) {
            vehicles.get().close();
        }
    }

    private boolean isInForce() {
        return other.orElseThrow().vehicles().join().stream()
                .filter(vehicle -> vehicle.id().equals(ID))
                .anyMatch(vehicle -> vehicle.health().fenceOn().equals(Optional.of(true)));
    }

    private void isPutInForceAgain(RobotKind kind) {
        client = Optional.of(new LinkClient(work, ArduPilotBoats.address(NUMBER) + "/" + (NUMBER + 1)));
        other = Optional.of(new MavlinkBase(
                List.of(AddressText.parse("mavlink:tcp:127.0.0.1:" + ArduPilotBoats.thirdPort(NUMBER))),
                ProcessClock::ms));
        client.get().keepTo(Optional.of(WATER), List.of(ROCK), kind);
        Await.until("its fence is in force", WAIT_S, this::isInForce);

        Await.until("it is told", WAIT_S, () -> {
            if (isInForce()) { // the base may not have heard before that it is
                assertThat(other.get()
                                .command(ID, VehicleCommand.of(SWITCH_FENCE, "switch its fence off"))
                                .join()
                                .isAccepted())
                        .isTrue();
            }
            return client.get().hasAlarm("the fence of vehicle " + ID + " was changed by somebody else (switched off");
        });

        Await.until("its fence is in force again", WAIT_S, this::isInForce);
        assertThat(client.get().hasAlarm("does not keep to the fence")).isFalse();
    }

    @Test
    void fenceOfABoatThatIsSwitchedOffByACommandIsPutInForceAgain() throws Exception {
        assumeTrue(ArduPilotBoats.areThere(), ArduPilotBoats::missing);
        vehicles = Optional.of(new ArduPilotBoats(NUMBER, 1, SPEED, work));
        isPutInForceAgain(RobotKind.BOAT);
    }

    @Test
    void fenceOfACopterThatIsSwitchedOffByACommandIsPutInForceAgain() throws Exception {
        assumeTrue(ArduPilotBoats.areThere(), ArduPilotBoats::missing);
        vehicles = Optional.of(ArduPilotBoats.copters(NUMBER, 1, SPEED, work));
        isPutInForceAgain(RobotKind.COPTER);
    }
}
