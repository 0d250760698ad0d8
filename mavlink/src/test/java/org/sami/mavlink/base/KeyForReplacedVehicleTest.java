package org.sami.mavlink.base;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.SlowableClock;
import org.sami.mavlink.testing.SmallBoat;
import org.sami.mavlink.testing.SmallCopter;
import org.sami.mavlink.vehicle.VehicleId;
import org.sami.mavlink.vehicle.VehicleKind;

/** Another vehicle comes with the system id of one that is being given a key, which takes some seconds. */
@Timeout(300)
class KeyForReplacedVehicleTest {
    private static final VehicleId ID = new VehicleId(7, 1);

    @Test
    void givingAKeyFailsAtOnceWhereAnotherVehicleAnswers() throws Exception {
        SlowableClock clock = new SlowableClock();
        SmallBoat boat = new SmallBoat(7, 45.7, 10.72, 1);
        try (MavlinkBase base = KeyGivingBase.linked(boat, clock)) {
            Await.until("it is heard", () -> !base.vehicles().join().isEmpty());
            CompletableFuture<Void> giving = base.giveKey(ID);
            clock.slow(true); // no try ends meanwhile
            boat.close();
            try (SmallCopter copter = new SmallCopter(7, 45.7, 10.72, 1, boat.port(), 20)) {
                Await.until(
                        "another vehicle answers",
                        () -> base.vehicles().join().get(0).kind() == VehicleKind.COPTER);

                assertThatThrownBy(giving::join)
                        .isInstanceOf(CompletionException.class)
                        .hasMessageContaining("another vehicle answers as vehicle 7");
            }
        } finally {
            boat.close();
        }
    }
}
