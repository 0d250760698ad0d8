package org.sami.mavlink.vehicle;

import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.sami.mavlink.address.MavlinkAddress;

/**
 * The ground stations besides this base whose heartbeats arrive on its links. ArduPilot passes the heartbeats of each of its links on to the others.
 */
final class OtherStations {
    private static final long HEARD_MS = 5_000;

    private final Map<MavlinkAddress, Map<Integer, Long>> heard = new HashMap<>();

    /** A station's heartbeat came on a link. */
    void heard(MavlinkAddress link, int system, long nowMs) {
        Map<Integer, Long> there = heard.computeIfAbsent(link, first -> new HashMap<>());
        there.values().removeIf(atMs -> nowMs - atMs > HEARD_MS);
        there.put(system, nowMs);
    }

    /** The system ids of those that were heard just now on one of these links, ascending. */
    List<Integer> on(Collection<MavlinkAddress> links, long nowMs) {
        return links.stream()
                .flatMap(link -> heard.getOrDefault(link, Map.of()).entrySet().stream())
                .filter(station -> nowMs - station.getValue() <= HEARD_MS)
                .map(Map.Entry::getKey)
                .distinct()
                .sorted()
                .toList();
    }
}
