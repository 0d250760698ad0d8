package org.sami.mavlink.command;

import io.dronefleet.mavlink.common.RcChannelsOverride;
import java.util.Map;
import org.sami.mavlink.vehicle.VehicleId;

/**
 * Takes the place of radio control on channels 1 to 8 (RC_CHANNELS_OVERRIDE): pulses in microseconds by channel. Channels that are not named are left to the
 * radio; the autopilot forgets all after its {@code RC_OVERRIDE_TIME}.
 */
public record RadioOverride(Map<Integer, Integer> pulsesUs) {
    private static final int CHANNELS = 8;
    private static final int SHORTEST_US = 800;
    private static final int LONGEST_US = 2_200;

    /** An override; an empty one gives all channels back.
     *
     * @throws IllegalArgumentException if a channel is not 1 to 8, or a pulse not 800 to 2200
     */
    public RadioOverride {
        pulsesUs = Map.copyOf(pulsesUs);
        pulsesUs.forEach((channel, us) -> {
            if (channel < 1 || channel > CHANNELS || us < SHORTEST_US || us > LONGEST_US) {
                throw new IllegalArgumentException("channel " + channel + " cannot have a pulse of " + us + " us");
            }
        });
    }

    /** The same as a message of the library. */
    public Object message(VehicleId vehicle) {
        return RcChannelsOverride.builder()
                .targetSystem(vehicle.system())
                .targetComponent(vehicle.component())
                .chan1Raw(pulse(1))
                .chan2Raw(pulse(2))
                .chan3Raw(pulse(3))
                .chan4Raw(pulse(4))
                .chan5Raw(pulse(5))
                .chan6Raw(pulse(6))
                .chan7Raw(pulse(7))
                .chan8Raw(pulse(8))
                .build();
    }

    private int pulse(int channel) {
        return pulsesUs.getOrDefault(channel, 0); // 0 gives a channel back to the radio
    }
}
