package org.sami.mavlink.link;

import java.util.Map;
import java.util.Optional;
import org.sami.mavlink.address.MavlinkAddress;

/**
 * What is known of a link.
 *
 * @param fault why it is broken, or what is wrong with what comes, in words for people; empty where all is well
 * @param senders what is wrong with how single vehicles speak there, by their system ids
 * @param bytes how many bytes came
 * @param messages how many messages came that could be read
 * @param lost the part of the messages that did not come, 0 to 1, by the numbers that senders give them
 * @param refused how many messages were refused for their signatures, and why
 * @param hasRadio whether a radio reports itself there
 * @param rssi the radio's strength of signal here, 0 to 254 as the radio counts; empty where no radio reports it
 * @param remoteRssi the same at the other end
 */
public record MavlinkLinkReport(
        MavlinkAddress address,
        MavlinkLinkState state,
        Optional<String> fault,
        Map<Integer, SenderFault> senders,
        long bytes,
        long messages,
        double lost,
        Map<SignatureFault, Long> refused,
        boolean hasRadio,
        Optional<Integer> rssi,
        Optional<Integer> remoteRssi) {
    /** A report. */
    public MavlinkLinkReport {
        senders = Map.copyOf(senders);
        refused = Map.copyOf(refused);
    }
}
