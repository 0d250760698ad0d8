package org.sami.crw.proxy.tcp;

import java.net.InetSocketAddress;
import java.util.Optional;

/**
 * One link of the base at a moment.
 *
 * @param boatId the boat at the address; empty while unknown
 * @param connected whether a connection is open
 * @param connections number of connections so far
 * @param lastEvent the last event in words; empty if there was none
 * @param refused whether the last event is a refusal, by this base or by the peer
 * @param failedTries number of connections that failed or ended since a boat was last heard
 * @param failingForMs time since the first of these; 0 if there was none
 */
public record LinkReport(
        InetSocketAddress address,
        Optional<String> boatId,
        boolean connected,
        long connections,
        String lastEvent,
        boolean refused,
        long failedTries,
        long failingForMs) {}
