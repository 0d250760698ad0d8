package org.sami.crw.proxy.tcp;

import java.net.InetSocketAddress;
import java.util.List;
import java.util.Optional;
import org.sami.crw.proxy.gateway.LinkStatus;

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
 * @param linkStatuses the links of MAVLink on which a vehicle is reached there; empty for boats of ours
 */
public record LinkReport(
        InetSocketAddress address,
        Optional<String> boatId,
        boolean connected,
        long connections,
        String lastEvent,
        boolean refused,
        long failedTries,
        long failingForMs,
        List<LinkStatus> linkStatuses) {

    /** A report. */
    public LinkReport {
        linkStatuses = List.copyOf(linkStatuses);
    }

    /** The same of a second link to the boat, which has no events of its own. */
    LinkReport at(InetSocketAddress second) {
        return new LinkReport(
                second, boatId, connected, connections, lastEvent, refused, failedTries, failingForMs, linkStatuses);
    }
}
