package org.sami.crw.operator.map;

import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentSkipListMap;
import org.sami.crw.proxy.status.BoatReading;

/**
 * The newest reading of each channel of each boat. Safe for use by several threads, of which none waits for another: boats measure often, and whoever shows this looks when it
 * has room.
 */
public final class NewestReadings {
    private final Map<Place, NewestReading> readings = new ConcurrentSkipListMap<>();

    private record Place(String boat, SensorChannel channel) implements Comparable<Place> {
        private static final Comparator<Place> ORDER =
                Comparator.comparing(Place::boat).thenComparing(Place::channel);

        @Override
        public int compareTo(Place other) {
            return ORDER.compare(this, other);
        }
    }

    /** Takes a reading; the one before of its channel is forgotten. */
    public void take(String boat, BoatReading reading, long atMillis) {
        SensorChannel channel = new SensorChannel(reading.sensor(), reading.channel(), reading.unit());
        readings.put(
                new Place(boat, channel),
                new NewestReading(boat, channel, reading.values().get(0), reading.position(), atMillis));
    }

    /** Forgets what a boat measured. */
    public void remove(String boat) {
        readings.keySet().removeIf(place -> place.boat().equals(boat));
    }

    /** Forgets all. */
    public void clear() {
        readings.clear();
    }

    /** All of them, by boat and channel. */
    public List<NewestReading> all() {
        return List.copyOf(readings.values());
    }
}
