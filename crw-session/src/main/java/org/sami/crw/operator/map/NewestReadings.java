package org.sami.crw.operator.map;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.sami.crw.proxy.status.BoatReading;

/** The newest reading of each channel of each boat. Safe for use by several threads: boats measure often, and whoever shows this looks when it has room. */
public final class NewestReadings {
    private final Map<String, Map<SensorChannel, NewestReading>> byBoat = new TreeMap<>();

    /** Takes a reading; the one before of its channel is forgotten. */
    public synchronized void take(String boat, BoatReading reading, long atMillis) {
        SensorChannel channel = new SensorChannel(reading.sensor(), reading.channel(), reading.unit());
        byBoat.computeIfAbsent(boat, one -> new TreeMap<>())
                .put(channel, new NewestReading(boat, channel, reading.values().get(0), reading.position(), atMillis));
    }

    /** Forgets what a boat measured. */
    public synchronized void remove(String boat) {
        byBoat.remove(boat);
    }

    /** Forgets all. */
    public synchronized void clear() {
        byBoat.clear();
    }

    /** All of them, by boat and channel. */
    public synchronized List<NewestReading> all() {
        List<NewestReading> all = new ArrayList<>();
        byBoat.values().forEach(channels -> all.addAll(channels.values()));
        return all;
    }
}
