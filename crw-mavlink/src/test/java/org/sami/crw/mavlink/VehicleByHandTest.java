package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.Ack;
import org.sami.boat.link.FleetStop;
import org.sami.boat.link.Teleoperate;
import org.sami.boat.server.testing.Await;
import org.sami.mavlink.testing.SmallBoat;

/** A vehicle that is to be driven by hand and does not let itself: the operator is told why. */
@Timeout(300)
class VehicleByHandTest {
    private static final int ARM = 400;
    private static final int HOLD = 4;
    private static final String NOT_DRIVEN = "mav5 is not driven by hand: ";

    @TempDir
    private Path folder;

    private SmallBoat boat;
    private LinkClient client;

    @BeforeEach
    void start() throws Exception {
        boat = new SmallBoat(5, 45.7, 10.72, 1);
        client = new LinkClient(folder, boat.address() + "/5");
    }

    @AfterEach
    void end() throws Exception {
        client.close();
        boat.close();
    }

    @Test
    void refusalToArmIsToldInTheAutopilotsWordsOnceAsLongAsTheSticksAreHeld() {
        String why = NOT_DRIVEN + "vehicle 5 fails to arm: PreArm: GPS 1: Bad fix";
        boat.faults().refuseArming("PreArm: GPS 1: Bad fix");

        holdUntil("it is told", () -> client.hasAlarm(why));
        boat.faults().refuseArming("");
        holdUntil("it is armed all the same", boat::isArmed);

        assertThat(client.alarms(NOT_DRIVEN)).hasSize(1);
    }

    private void holdUntil(String what, BooleanSupplier so) {
        Await.until(what, () -> {
            client.say(new Teleoperate(0.5, 0));
            return so.getAsBoolean();
        });
    }

    @Test
    void vehicleThatHeedsNoOrderIsToldOfOnceItIsToStandAgain() {
        boat.faults().ignoresOrders(true);

        client.say(new Teleoperate(0.5, 0));

        client.untilAlarm(NOT_DRIVEN + "vehicle 5 has not come into mode MANUAL, armed, within 2 s");
    }

    /** The order to arm is sent again until it is answered. */
    @Test
    void vehicleWhoseDriverLeavesAsItIsToBeArmedIsNotArmed() {
        client.slow(true); // the order is sent again once this ends
        boat.faults().ignoresCommand(ARM);
        client.say(new Teleoperate(0.5, 0));
        Await.until("it is ordered to be armed", () -> boat.faults().ignoredOrders() > 0);
        boat.faults().ignoresCommand(0);

        client.leave();
        Await.until("it is stopped", () -> boat.mode() == HOLD);
        client.slow(false);

        Await.holds("it stays disarmed", 4, () -> !boat.isArmed());
        assertThat(boat.armings()).isZero();
    }

    @Test
    void fleetStopIsTheReason() {
        assertThat(client.ask(new FleetStop("stop"))).isInstanceOf(Ack.class);

        client.say(new Teleoperate(0.5, 0));

        client.untilAlarm(NOT_DRIVEN + "the fleet stop is latched, release it first");
        assertThat(boat.isArmed()).isFalse();
    }
}
