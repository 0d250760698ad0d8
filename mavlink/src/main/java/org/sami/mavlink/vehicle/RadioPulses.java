package org.sami.mavlink.vehicle;

import io.dronefleet.mavlink.common.RcChannels;
import java.util.List;
import java.util.stream.Stream;

/** Reads the pulses of a radio control from the message that has them. */
final class RadioPulses {
    private static final int NOT_USED = 65_535;

    private RadioPulses() {}

    /** The pulse of each channel that there is, microseconds; 0 where it has none. */
    static List<Integer> of(RcChannels radio) {
        return Stream.of(
                        radio.chan1Raw(),
                        radio.chan2Raw(),
                        radio.chan3Raw(),
                        radio.chan4Raw(),
                        radio.chan5Raw(),
                        radio.chan6Raw(),
                        radio.chan7Raw(),
                        radio.chan8Raw(),
                        radio.chan9Raw(),
                        radio.chan10Raw(),
                        radio.chan11Raw(),
                        radio.chan12Raw(),
                        radio.chan13Raw(),
                        radio.chan14Raw(),
                        radio.chan15Raw(),
                        radio.chan16Raw(),
                        radio.chan17Raw(),
                        radio.chan18Raw())
                .limit(radio.chancount())
                .map(pulse -> pulse == NOT_USED ? 0 : pulse)
                .toList();
    }
}
