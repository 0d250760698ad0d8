package org.sami.mavlink.vehicle;

import java.util.Map;
import java.util.OptionalInt;
import org.sami.mavlink.address.MavlinkAddress;

/**
 * The radios that report themselves ({@code RADIO_STATUS}), each on its link. A radio may be behind a network too, such as one on a router of links.
 *
 * @param weaker for each link with such a radio the strength of its signal at its weaker end, 0 to 254 as the radio counts; empty where it does not know that
 */
public record RadioSignals(Map<MavlinkAddress, OptionalInt> weaker) {
    /** No radio reports itself. */
    public static final RadioSignals NONE = new RadioSignals(Map.of());

    /** What telemetry radios carry as they are delivered, in baud; taken for one whose speed nobody has said. */
    public static final int USUAL_BAUD = 57_600;

    private static final int OF_NETWORK = Integer.MAX_VALUE / 2;

    /** Signals. */
    public RadioSignals {
        weaker = Map.copyOf(weaker);
    }

    /** What a link carries, in baud: as its address says, else {@link #USUAL_BAUD} where a radio reports itself there; empty for a network. */
    public OptionalInt speedBaud(MavlinkAddress link) {
        return link.speedBaud().isPresent() || !weaker.containsKey(link)
                ? link.speedBaud()
                : OptionalInt.of(USUAL_BAUD);
    }

    /** Whether a link is no network all the way, and carries little. */
    boolean isSlow(MavlinkAddress link) {
        return speedBaud(link).isPresent();
    }

    /** The strength of a link's signal, which is above that of each radio where none is known. */
    int strength(MavlinkAddress link) {
        return weaker.getOrDefault(link, OptionalInt.empty()).orElse(OF_NETWORK);
    }
}
