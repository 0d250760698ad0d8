package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.mavlink.address.AddressText;
import org.sami.mavlink.base.MavlinkBase;
import org.sami.mavlink.testing.SmallBoat;
import org.sami.mavlink.vehicle.VehicleId;

/**
 * Parameters that somebody changes where the vehicle does not say so, as on board, or where its word is lost. The test's thread is the gateway's, and its numbers are
 * the clock.
 */
@Timeout(300)
class WatchedParametersTest {
    private static final VehicleId ID = new VehicleId(5, 1);
    private static final String ENABLE = "FENCE_ENABLE";
    private static final String ACTION = "FENCE_ACTION";
    private static final long MINUTE_MS = 60_000;

    private final BlockingQueue<Runnable> work = new LinkedBlockingQueue<>();
    private final BlockingQueue<String> found = new LinkedBlockingQueue<>();
    private SmallBoat boat;
    private MavlinkBase base;
    private WatchedParameters watched;

    @BeforeEach
    void watch() throws Exception {
        boat = new SmallBoat(5, 45.7, 10.72, 1);
        base = new MavlinkBase(List.of(AddressText.parse(boat.address())), ProcessClock::ms);
        Await.until("it is heard", () -> !base.vehicles().join().isEmpty());
        watched = new WatchedParameters(base, ID, work::add, (name, value, words) -> found.add(words));
        watched.tick(0, true);
        watched.holds(ENABLE, 0);
        watched.holds(ACTION, 1);
    }

    @AfterEach
    void end() throws Exception {
        base.close();
        boat.close();
    }

    /** Nothing that was asked for before is under way any longer, as parameters are answered one after the other. */
    private void untilAnswered() {
        base.parameter(ID, "WP_SPEED").join();
        for (Runnable next = work.poll(); next != null; next = work.poll()) {
            next.run();
        }
    }

    private void untilFound(int words) {
        Await.until("it is found", () -> {
            for (Runnable next = work.poll(); next != null; next = work.poll()) {
                next.run();
            }
            return found.size() == words;
        });
    }

    @Test
    void areReadAgainEachMinuteAsLongAsTheVehicleIsCommanded() {
        boat.parameter(ENABLE, 1);
        boat.parameter(ACTION, 2);

        watched.tick(MINUTE_MS - 1, true);
        untilAnswered();
        assertThat(found).as("before a minute has passed").isEmpty();
        watched.tick(MINUTE_MS, false);
        untilAnswered();
        assertThat(found).as("while it is not commanded").isEmpty();

        watched.tick(MINUTE_MS + 1, true);
        untilFound(2);
        assertThat(found).containsExactly("FENCE_ENABLE 1, before 0", "FENCE_ACTION 2, before 1");

        boat.parameter(ENABLE, 0);
        watched.tick(2 * MINUTE_MS, true);
        untilAnswered();
        assertThat(found).as("before another minute has passed").hasSize(2);
        watched.tick(2 * MINUTE_MS + 1, true);
        untilFound(3);
        assertThat(found).contains("FENCE_ENABLE 0, before 1");
    }

    @Test
    void areNotReadWhileTheyAreSet() {
        boat.parameter(ENABLE, 1);
        watched.pause();

        watched.tick(MINUTE_MS, true);
        untilAnswered();
        assertThat(found).isEmpty();

        watched.resume();
        watched.tick(MINUTE_MS, true);
        untilFound(1);
    }
}
