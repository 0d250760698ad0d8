package org.sami.crw.session;

import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.sami.crw.message.OperatorMessage;
import org.sami.crw.operator.map.SeenVessel;
import org.sami.crw.proxy.status.BoatReading;
import org.sami.crw.service.Geodesy;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Priority;

/** Messages about vessels that are not of the base: one when a boat sees a vessel that nobody saw for a minute. For the fleet's thread. */
final class VesselNews {
    private static final long FORGOTTEN_MS = 60_000;

    private final Map<Integer, Long> seenMs = new HashMap<>();

    /** The message about what a boat has measured, if it is one. */
    Optional<OperatorMessage> seen(String boat, BoatReading reading, long nowMillis) {
        Optional<SeenVessel> vessel = SeenVessel.of(reading);
        if (vessel.isEmpty()) {
            return Optional.empty();
        }
        Long before = seenMs.put(vessel.get().number(), nowMillis);
        if (before != null && nowMillis - before <= FORGOTTEN_MS) {
            return Optional.empty();
        }
        String text = String.format(
                Locale.ROOT,
                "%s sees %s, %.0f m away",
                boat,
                vessel.get().words(),
                Geodesy.distanceM(vessel.get().from(), vessel.get().position()));
        return Optional.of(new OperatorMessage(
                nowMillis, Ids.NONE, OperatorMessage.Source.DOMAIN, Priority.MEDIUM, text, List.of(boat), ""));
    }
}
