package org.sami.mavlink.link;

import io.dronefleet.mavlink.protocol.MavlinkPacket;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/** How those that send on a link speak, by their system ids; radios that report themselves are none of them. Not safe for use by several threads. */
final class LinkSenders {
    /** {@code RADIO_STATUS}: a radio's own, often in MAVLink 1 and without a signature, whatever the vehicle speaks. */
    static final int RADIO_STATUS = 109;

    private static final String ONLY_A_RADIO =
            "only a radio is heard, and no vehicle: is the vehicle on, and is its radio paired with this one?";
    private static final int RADIO_REPORTS = 3; // of a radio alone: vehicles speak every second

    private static final int AUTOPILOT = 1;

    private final Map<Integer, Speech> senders = new HashMap<>();
    private boolean isAnyRefused;
    private int radioReports;

    /** What has come of one sender. */
    private static final class Speech {
        boolean second; // a message of MAVLink 2
        boolean signed;
    }

    /** A message came that is refused for its signature: somebody speaks there. */
    void refused() {
        isAnyRefused = true;
    }

    /** A message came that is taken. */
    void came(MavlinkPacket packet) {
        if (packet.getMessageId() == RADIO_STATUS) {
            radioReports++;
            return;
        }
        Speech speech = senders.computeIfAbsent(packet.getSystemId(), system -> new Speech());
        speech.second |= packet.isMavlink2();
        if (packet.getComponentId() == AUTOPILOT) { // a camera beside it need not sign
            speech.signed = LinkSigning.isSigned(packet);
        }
    }

    /**
     * What is wrong with how some speak, by their system ids.
     *
     * @param hasKey whether signatures are compared here
     */
    Map<Integer, SenderFault> faults(boolean hasKey) {
        Map<Integer, SenderFault> faults = new TreeMap<>();
        senders.forEach((system, speech) -> {
            if (!speech.second) {
                faults.put(system, SenderFault.FIRST_VERSION_ONLY);
            } else if (speech.signed && !hasKey) {
                faults.put(system, SenderFault.KEY_IS_MISSING);
            }
        });
        return faults;
    }

    /** What is wrong with all that comes, in words for people. */
    Optional<String> fault() {
        if (senders.isEmpty()) {
            return isAnyRefused || radioReports < RADIO_REPORTS ? Optional.empty() : Optional.of(ONLY_A_RADIO);
        }
        return senders.values().stream().anyMatch(speech -> speech.second)
                ? Optional.empty()
                : Optional.of("it " + SenderFault.FIRST_VERSION_ONLY.words());
    }
}
