package org.sami.mavlink.testing;

import io.dronefleet.mavlink.common.RcChannels;
import java.util.Arrays;
import java.util.Optional;

/** The receiver of a pilot's radio control on a small vehicle. It tells no pulses before the pilot has moved something. */
public final class SmallVehicleRadio {
    private static final int CHANNELS = 8;
    private static final int MIDDLE_US = 1_500;

    private final int[] pulsesUs = new int[CHANNELS];
    private boolean received = true;
    private boolean moved;

    SmallVehicleRadio() {
        Arrays.fill(pulsesUs, MIDDLE_US);
    }

    /** The pilot moves a stick or a switch, on a channel from 1 on, to a pulse in microseconds. */
    public synchronized void move(int channel, int pulseUs) {
        pulsesUs[channel - 1] = pulseUs;
        moved = true;
    }

    /** No pilot's radio control is received from now on. */
    public synchronized void none() {
        received = false;
    }

    /** What it receives. */
    synchronized Optional<RcChannels> message() {
        if (!received) {
            return Optional.of(RcChannels.builder().chancount(0).build());
        }
        return moved
                ? Optional.of(RcChannels.builder()
                        .chancount(CHANNELS)
                        .chan1Raw(pulsesUs[0])
                        .chan2Raw(pulsesUs[1])
                        .chan3Raw(pulsesUs[2])
                        .chan4Raw(pulsesUs[3])
                        .chan5Raw(pulsesUs[4])
                        .chan6Raw(pulsesUs[5])
                        .chan7Raw(pulsesUs[6])
                        .chan8Raw(pulsesUs[7])
                        .build())
                : Optional.empty();
    }
}
