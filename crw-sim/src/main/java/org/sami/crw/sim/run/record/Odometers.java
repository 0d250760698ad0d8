package org.sami.crw.sim.run.record;

import java.util.Map;
import java.util.NavigableMap;
import java.util.TreeMap;
import org.sami.session.record.FleetHistory;
import org.sami.session.record.SessionTelemetry;

/** How far the boats of a session had driven at each moment, from its telemetry. Used by one thread. */
public final class Odometers implements SessionTelemetry.Reader {
    private final Map<String, NavigableMap<Long, Double>> metresByBoat = new TreeMap<>();

    @Override
    public void pose(long atMillis, String boat, FleetHistory.Report report, double distanceM) {
        metresByBoat.computeIfAbsent(boat, id -> new TreeMap<>()).put(atMillis, distanceM);
    }

    /** Whether no boat has said where it was. */
    public boolean areEmpty() {
        return metresByBoat.isEmpty();
    }

    /** Metres that a boat drove between two moments of the session; 0 for one that said nothing. */
    public double metres(String boat, long fromMillis, long toMillis) {
        NavigableMap<Long, Double> metres = metresByBoat.getOrDefault(boat, new TreeMap<>());
        return metres.isEmpty() ? 0 : at(metres, toMillis) - at(metres, fromMillis);
    }

    private static double at(NavigableMap<Long, Double> metres, long millis) {
        Map.Entry<Long, Double> known = metres.floorEntry(millis);
        return known == null ? metres.firstEntry().getValue() : known.getValue();
    }
}
