package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.mavlink.address.AddressText;
import org.sami.mavlink.base.MavlinkBase;
import org.sami.mavlink.testing.SmallBoat;
import org.sami.mavlink.vehicle.VehicleKind;
import org.sami.mavlink.vehicle.VehicleSnapshot;

/** Whether a pilot can have changed a boat's state, from what its radio control sends. Its mode switch stands for HOLD, and it is in MANUAL. */
@Timeout(60)
class RadioControlTest {
    private static final int MANUAL = 0;
    private static final int HOLD = 4;
    private static final int SWITCH = 8;
    private static final int ANOTHER_SWITCH = 7;
    private static final int MIDDLE_US = 1_500;
    private static final int HIGH_US = 2_000;
    private static final long CHANGED_MS = 59_000;

    private final Queue<Runnable> work = new ConcurrentLinkedQueue<>();
    private SmallBoat boat;
    private MavlinkBase base;
    private RadioControl radio;
    private VehicleSnapshot vehicle;

    @BeforeEach
    void readItsRadio() throws Exception {
        boat = new SmallBoat(7, 45.7, 10.72, 20);
        boat.parameter("RCMAP_ROLL", 1);
        boat.parameter("MODE_CH", SWITCH);
        List.of(1, 2, 3, 4, 5, 6).forEach(number -> boat.parameter("MODE" + number, HOLD));
        boat.takenByPilot(MANUAL, true);
        base = new MavlinkBase(List.of(AddressText.parse(boat.address())), ProcessClock::ms);
        Await.until(
                "it is driven by hand",
                10,
                () -> base.vehicles().join().stream()
                        .anyMatch(known -> known.armed() && known.mode().equals("MANUAL")));
        vehicle = base.vehicles().join().get(0);
        radio = new RadioControl(base, vehicle.id(), VehicleKind.BOAT, work::add);
        radio.read();
        radio.heard(pulsesUs(), 10_000);
        Await.until("its modes are read", 10, () -> {
            drain();
            radio.heard(pulsesUs(), 20_000);
            return radio.isRuledOut(vehicle, false, 15_000);
        });
    }

    private void drain() {
        for (Runnable next = work.poll(); next != null; next = work.poll()) {
            next.run();
        }
    }

    @AfterEach
    void end() throws Exception {
        base.close();
        boat.close();
    }

    private static List<Integer> pulsesUs() {
        return new ArrayList<>(Collections.nCopies(8, MIDDLE_US));
    }

    private static List<Integer> pulsesUs(int channel, int pulseUs) {
        List<Integer> all = pulsesUs();
        all.set(channel - 1, pulseUs);
        return all;
    }

    @Test
    void pilotWhoMovesNothingIsRuledOut() {
        radio.heard(pulsesUs(), 60_000);

        assertThat(radio.isRuledOut(vehicle, false, CHANGED_MS)).isTrue();
    }

    @Test
    void pilotWhoMovesAnotherSwitchIsNotRuledOut() {
        radio.heard(pulsesUs(ANOTHER_SWITCH, HIGH_US), 60_000);

        assertThat(radio.isRuledOut(vehicle, false, CHANGED_MS)).isFalse();
    }

    @Test
    void pilotWhoMayArmWithASwitchIsNotRuledOut() {
        radio.heard(pulsesUs(), 58_000);
        radio.heard(pulsesUs(ANOTHER_SWITCH, HIGH_US), 60_000);

        assertThat(radio.isRuledOut(vehicle, true, CHANGED_MS)).isFalse();
    }

    @Test
    void pilotOfWhomNothingWasReceivedBeforeIsNotRuledOut() {
        radio.heard(pulsesUs(), 60_000);

        assertThat(radio.isRuledOut(vehicle, false, 5_000)).isFalse();
    }

    @Test
    void pilotIsNotRuledOutWhereItIsDisarmed() {
        VehicleSnapshot armed = vehicle;
        boat.takenByPilot(MANUAL, false);
        Await.until("it is disarmed", 10, () -> !base.vehicles().join().get(0).armed());
        RadioOrStation person = new RadioOrStation(radio);
        person.reported(armed, base.vehicles().join().get(0), CHANGED_MS);
        radio.heard(pulsesUs(), 60_000);

        assertThat(person.who(base.vehicles().join().get(0), 60_000)).startsWith("a pilot or ");
    }
}
