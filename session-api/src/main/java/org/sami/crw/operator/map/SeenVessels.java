package org.sami.crw.operator.map;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.sami.spn.protocol.Ids;

/** The vessels that are not of the base and that boats see, by number. For the thread of the models. */
public final class SeenVessels {
    /** A vessel that no boat has seen for so long, in ms, is no longer on the map. */
    public static final long KEPT_MS = 10_000;

    private final Map<Integer, Seen> vessels = new TreeMap<>();

    private record Seen(SeenVessel vessel, long atMillis) {}

    /** A boat has seen one. */
    public void seen(SeenVessel vessel, long atMillis) {
        vessels.put(vessel.number(), new Seen(vessel, atMillis));
    }

    /** Forgets those that nobody sees any more. Returns whether there were some. */
    public boolean tick(long nowMillis) {
        return vessels.values().removeIf(seen -> nowMillis - seen.atMillis() > KEPT_MS);
    }

    public void clear() {
        vessels.clear();
    }

    /** Where they were seen last, with what they are. */
    public List<ShownPlace> places() {
        return vessels.values().stream()
                .map(seen -> new ShownPlace(
                        Ids.NONE, seen.vessel().words(), seen.vessel().position()))
                .toList();
    }
}
