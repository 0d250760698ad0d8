package org.sami.mavlink.base;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.SlowableClock;
import org.sami.mavlink.address.AddressText;
import org.sami.mavlink.link.LinkSigning;
import org.sami.mavlink.link.SigningKey;
import org.sami.mavlink.testing.SmallBoat;
import org.sami.mavlink.testing.SmallCopter;
import org.sami.mavlink.vehicle.VehicleId;
import org.sami.mavlink.vehicle.VehicleKind;

/** Another vehicle comes with the system id of one that is being given a key, which takes some seconds. */
@Timeout(300)
class KeyForReplacedVehicleTest {
    private static final VehicleId ID = new VehicleId(7, 1);
    private static final byte[] SECRET = new byte[SigningKey.BYTES];

    static {
        SECRET[0] = 1; // none of zeros alone is a key
    }

    @Test
    void givingAKeyFailsAtOnceWhereAnotherVehicleAnswers() throws Exception {
        LinkSigning signing = new LinkSigning(new SigningKey(SECRET), Instant::now, LinkSigning.Unsigned.TAKEN);
        SlowableClock clock = new SlowableClock();
        SmallBoat boat = new SmallBoat(7, 45.7, 10.72, 1);
        try (MavlinkBase base = new MavlinkBase(
                List.of(AddressText.parse(boat.address())),
                clock,
                new MavlinkBaseOptions(Optional.empty(), Optional.of(signing)))) {
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
