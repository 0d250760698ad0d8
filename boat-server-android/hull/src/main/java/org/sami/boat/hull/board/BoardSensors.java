package org.sami.boat.hull.board;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.sami.boat.hull.nmea.NmeaSentence;
import org.sami.boat.server.vehicle.Sensor;

/**
 * The instruments that a board can have, and what they measured last. The vocabulary's channels and units: temperature in °C, conductivity in µS/cm, oxygen
 * in mg/L, ph, depth in m. The first instrument of a type has the type's name; one of the same type in another slot has the slot's as well, as {@code es2 s3}, so
 * that their measurements never mix. A value that cannot be read, or that no water has, is refused. Safe for use by several threads.
 */
final class BoardSensors {
    private static final long PERIOD_MS = 100; // the server reads each channel so often, and gets each measurement once
    private static final int MAX_WAITING = 16;
    private static final List<String> SLOTS =
            Collections.unmodifiableList(Arrays.asList("s0", "s1", "s2", "s3", "s4", "s5", "s6", "s7", "s8", "s9"));

    private final Map<String, Channel> channels = new LinkedHashMap<>();
    private final Map<String, String> firstSlots = new ConcurrentHashMap<>(); // by type

    BoardSensors() {
        add("");
        for (String slot : SLOTS) {
            add(" " + slot);
        }
    }

    private void add(String suffix) {
        add("es2" + suffix, "conductivity", "µS/cm", 0, 100_000);
        add("es2" + suffix, "temperature", "°C", -5, 60);
        add("atlas_do" + suffix, "oxygen", "mg/L", 0, 50);
        add("atlas_ph" + suffix, "ph", "", 0, 14);
        add("hds" + suffix, "depth", "m", 0, 1000);
        add("hds" + suffix, "temperature", "°C", -5, 60);
        add("winch" + suffix, "depth", "m", 0, 1000);
    }

    private void add(String instrument, String channel, String unit, double least, double most) {
        channels.put(instrument + " " + channel, new Channel(instrument, channel, unit, least, most));
    }

    /** All channels. */
    List<Sensor> all() {
        return Collections.unmodifiableList(new ArrayList<Sensor>(channels.values()));
    }

    /** Takes what an instrument in a slot measured; whether all of it could be read. */
    boolean take(String slot, String type, String data) {
        String first = firstSlots.getOrDefault(type, slot);
        String instrument = first.equals(slot) ? type : type + " " + slot;
        boolean read = read(type, instrument + " ", data);
        if (read) {
            firstSlots.putIfAbsent(type, slot); // damaged lines name slots that are not there
        }
        return read;
    }

    private boolean read(String type, String of, String data) {
        switch (type) {
            case "es2":
                boolean alone = data.trim().indexOf(' ') < 0; // without a thermometer
                boolean warm = alone || put(of + "temperature", word(data, 1)); // one bad value spares the other
                return put(of + "conductivity", word(data, 0)) && warm;
            case "atlas_do":
                return put(of + "oxygen", word(data, 0));
            case "atlas_ph":
                return put(of + "ph", word(data, 0));
            case "winch":
                return put(of + "depth", word(data, 0));
            case "hds":
                return sounder(of, data);
            default:
                return false;
        }
    }

    private boolean sounder(String of, String data) {
        Optional<NmeaSentence> sentence = NmeaSentence.read(data, false);
        if (!sentence.isPresent()) {
            return false;
        }
        switch (sentence.get().type()) {
            case "DBT":
                return put(of + "depth", sentence.get().number(3));
            case "MTW":
                return put(of + "temperature", sentence.get().number(1));
            default:
                return true; // its position is not used
        }
    }

    private boolean put(String name, double value) {
        Channel channel = channels.get(name);
        return channel != null && channel.put(value);
    }

    /** A number of a text of numbers; NaN if it is none. */
    static double word(String data, int index) {
        String[] words = data.trim().split("\\s+", index + 2);
        if (index >= words.length || words[index].length() > 20) {
            return Double.NaN;
        }
        try {
            return Double.parseDouble(words[index]);
        } catch (NumberFormatException e) {
            return Double.NaN;
        }
    }

    /** One channel: its measurements wait until the server reads them, the newest {@link #MAX_WAITING}. */
    private static final class Channel implements Sensor {
        private final String instrument;
        private final String name;
        private final String unit;
        private final double least;
        private final double most;
        private final Deque<Double> waiting = new ArrayDeque<>();

        Channel(String instrument, String name, String unit, double least, double most) {
            this.instrument = instrument;
            this.name = name;
            this.unit = unit;
            this.least = least;
            this.most = most;
        }

        synchronized boolean put(double value) {
            if (!(value >= least && value <= most)) {
                return false;
            }
            if (waiting.size() == MAX_WAITING) {
                waiting.remove();
            }
            waiting.add(value);
            return true;
        }

        @Override
        public String name() {
            return instrument;
        }

        @Override
        public String channel() {
            return name;
        }

        @Override
        public String unit() {
            return unit;
        }

        @Override
        public long periodMs() {
            return PERIOD_MS;
        }

        @Override
        public synchronized List<Double> read() {
            Double next = waiting.poll();
            return next == null ? Collections.<Double>emptyList() : Sensor.single(next);
        }
    }
}
