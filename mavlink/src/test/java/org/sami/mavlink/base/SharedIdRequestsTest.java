package org.sami.mavlink.base;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.SlowableClock;
import org.sami.mavlink.mission.HeldKind;
import org.sami.mavlink.testing.SensorMessages;
import org.sami.mavlink.testing.SmallBoat;
import org.sami.mavlink.vehicle.VehicleId;

/** What a base sends to an id that two vehicles on one link have. */
@Timeout(300)
class SharedIdRequestsTest {
    private static final VehicleId ID = new VehicleId(7, 1);

    @Test
    void noListParameterOrKeyIsChanged() throws Exception {
        SlowableClock clock = new SlowableClock();
        try (SmallBoat boat = new SmallBoat(7, 45.7, 10.72, 1);
                MavlinkBase base = KeyGivingBase.linked(boat, clock)) {
            int[] sinceBootMs = {90_000_000};
            Await.until("two are noticed", () -> {
                sinceBootMs[0] += 250;
                boat.sends(SensorMessages.position(45.8, 10.72, sinceBootMs[0])); // the other one
                return base.vehicles().join().stream()
                        .anyMatch(one -> one.health().sharesId());
            });
            clock.slow(true); // as long as is asked, they count as two

            for (CompletableFuture<?> asked : List.of(
                    base.replace(ID, HeldKind.FENCE, List.of()),
                    base.setParameter(ID, "FS_GCS_ENABLE", 1),
                    base.giveKey(ID))) {
                assertThatThrownBy(asked::join).hasMessageContaining("two vehicles have the id 7");
            }
            assertThat(boat.parameter("FS_GCS_ENABLE")).isZero();
        }
    }
}
