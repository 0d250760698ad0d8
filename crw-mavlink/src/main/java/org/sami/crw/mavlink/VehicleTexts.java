package org.sami.crw.mavlink;

import java.lang.System.Logger.Level;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.sami.mavlink.vehicle.StatusText;
import org.sami.mavlink.vehicle.TextSeverity;
import org.sami.spn.protocol.Priority;

/** What a vehicle's autopilot says in words of its own, as messages to the operator. For the gateway's thread. */
final class VehicleTexts {
    private static final System.Logger LOG = System.getLogger(VehicleTexts.class.getName());
    private static final long REPEATED_MS =
            20_000; // autopilots say some things several times in a row, others every 30 s
    private static final int MOST_KEPT = 50;

    private final String name;
    private final Map<String, Long> told = new LinkedHashMap<>(); // what, and when, oldest first

    VehicleTexts(String name) {
        this.name = name;
    }

    /**
     * The weight that a text has as a message: high from warnings on, else low; empty for one that was told just before.
     *
     * @param isExpected it follows from an order of the base, so that it warns of nothing
     */
    Optional<Priority> weigh(StatusText text, boolean isExpected, long atMs) {
        String key = isExpected + " " + text.text(); // what warns is told also after what does not
        Long before = told.get(key);
        if (before != null && atMs - before < REPEATED_MS) {
            return Optional.empty();
        }
        told.remove(key);
        told.put(key, atMs);
        if (told.size() > MOST_KEPT) {
            told.remove(told.keySet().iterator().next());
        }
        if (!isExpected && text.severity().compareTo(TextSeverity.WARNING) <= 0) {
            return Optional.of(Priority.HIGH);
        }
        LOG.log(Level.DEBUG, "{0} says: {1}", name, text.text());
        return Optional.of(Priority.LOW);
    }

    /** A text in a message. */
    String words(StatusText text) {
        return name + " says: " + text.text();
    }
}
