package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.mavlink.address.AddressText;
import org.sami.mavlink.base.MavlinkBase;
import org.sami.mavlink.mission.HeldKind;
import org.sami.mavlink.mission.MissionItem;
import org.sami.mavlink.testing.SmallBoat;
import org.sami.mavlink.vehicle.VehicleId;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/** The fence of a vehicle step by step: the test's thread is the gateway's, and its numbers are the clock. */
@Timeout(900)
class VehicleFenceStepsTest {
    private static final VehicleId ID = new VehicleId(5, 1);
    private static final String ENABLE = "FENCE_ENABLE";
    private static final List<MissionItem> FENCE = fence(45.69);
    private static final List<MissionItem> OTHER = fence(45.71);
    private static final long AREAS_COME_MS = 10_000;

    private final BlockingQueue<Runnable> work = new LinkedBlockingQueue<>();
    private final BlockingQueue<String> alarms = new LinkedBlockingQueue<>();
    private List<String> kept = List.of();
    private SmallBoat boat;
    private MavlinkBase base;

    @BeforeEach
    void launch() throws Exception {
        boat = new SmallBoat(5, 45.7, 10.72, 1);
        base = new MavlinkBase(List.of(AddressText.parse(boat.address())), ProcessClock::ms);
        Await.until("it is heard", () -> !base.vehicles().join().isEmpty());
    }

    @AfterEach
    void end() throws Exception {
        base.close();
        boat.close();
    }

    private static List<MissionItem> fence(double lat) {
        GeoArea area = new GeoArea(
                List.of(GeoPoint.of(lat, 10.71), GeoPoint.of(lat, 10.73), GeoPoint.of(lat + 0.02, 10.72)), List.of());
        return FenceItems.of(Optional.of(area), List.of());
    }

    /** Its fence as a session finds it that knows what earlier ones gave to it. */
    private VehicleFence session(List<MissionItem> given) {
        kept = List.of(FenceItems.text(given));
        return new VehicleFence(base, ID, false, work::add, alarms::add, kept, fences -> kept = fences);
    }

    private void holds(List<MissionItem> fence) {
        boat.fence().put(fence);
        base.setParameter(ID, ENABLE, 1).join();
    }

    private void until(String words, BooleanSupplier what) {
        Await.until(words, () -> {
            for (Runnable next = work.poll(); next != null; next = work.poll()) {
                next.run();
            }
            return what.getAsBoolean();
        });
    }

    @Test
    void fenceOfAnEarlierSessionIsTakenAwayWhereThisOneHasNoAreas() {
        holds(FENCE);
        VehicleFence fence = session(FENCE);

        fence.tick(0, true);
        fence.tick(AREAS_COME_MS, true);

        until("nothing is kept", () -> kept.isEmpty());
        assertThat(boat.fence().items()).isEmpty();
        assertThat(boat.parameter(ENABLE)).isZero();
        assertThat(alarms).isEmpty();
    }

    @Test
    void areasThatComeSoonAfterTheCommandFindTheFenceInPlace() {
        holds(FENCE);
        VehicleFence fence = session(FENCE);
        fence.tick(0, true);
        fence.tick(AREAS_COME_MS - 1, true);
        base.held(ID, HeldKind.FENCE).join(); // lists are read one after the other
        assertThat(work).isEmpty();

        fence.want(FENCE);
        fence.tick(AREAS_COME_MS, true);

        until("it heeds it", () -> boat.parameter("FENCE_ACTION") == 2);
        assertThat(boat.fence().uploads()).isZero();
        assertThat(boat.parameter(ENABLE)).isEqualTo(1);
    }

    @Test
    void fenceThatItsOwnerHasPutThereSinceStays() {
        holds(OTHER);
        VehicleFence fence = session(FENCE);

        fence.tick(0, true);
        fence.tick(AREAS_COME_MS, true);

        until("nothing is kept", () -> kept.isEmpty());
        assertThat(boat.fence().items()).isEqualTo(OTHER);
        assertThat(boat.parameter(ENABLE)).isEqualTo(1);
    }

    @Test
    void fenceThatSomebodyElseChangesIsSetAgainOnceItIsCommandedFromHere() {
        VehicleFence fence = session(List.of());
        fence.want(FENCE);
        fence.tick(0, true);
        until("it is set", () -> boat.parameter(ENABLE) == 1 && work.isEmpty() && !kept.isEmpty());
        base.parameter(ID, ENABLE).join(); // parameters are read one after the other
        until("that is seen", work::isEmpty);
        fence.tick(1, false);

        boat.parameter(ENABLE, 0);
        fence.reported(ENABLE, 0);
        fence.tick(2, false);

        assertThat(alarms)
                .containsExactly("the fence of vehicle 5 was changed by somebody else (FENCE_ENABLE 0, before 1);"
                        + " that of this session is set again once it is commanded from here");
        assertThat(boat.parameter(ENABLE)).isZero();

        fence.tick(3, true);
        until("it is set again", () -> boat.parameter(ENABLE) == 1);
        assertThat(alarms).hasSize(1);
    }

    @Test
    void areasThatAreGivenUpWhileItIsReadAreNotSent() {
        holds(OTHER);
        VehicleFence fence = session(FENCE);
        fence.want(FENCE);
        fence.tick(0, true);
        Await.until("it is read", () -> !work.isEmpty());

        fence.want(List.of());
        until("that is seen", work::isEmpty);
        fence.tick(1, true);

        until("nothing is kept", () -> kept.isEmpty());
        assertThat(boat.fence().items()).isEqualTo(OTHER);
        assertThat(boat.fence().uploads()).isZero();
        assertThat(boat.parameter(ENABLE)).isEqualTo(1);
    }
}
