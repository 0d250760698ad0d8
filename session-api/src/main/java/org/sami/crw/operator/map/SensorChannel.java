package org.sami.crw.operator.map;

import java.util.Objects;

/**
 * A quantity that boats measure.
 *
 * @param unit of its values; empty for none
 */
public record SensorChannel(String sensor, String channel, String unit) implements Comparable<SensorChannel> {
    public SensorChannel {
        Objects.requireNonNull(sensor, "sensor");
        Objects.requireNonNull(channel, "channel");
        Objects.requireNonNull(unit, "unit");
    }

    /** Whether a person or a markup means it by this word: the sensor or its channel, in any case. */
    public boolean isCalled(String word) {
        return sensor.equalsIgnoreCase(word)
                || channel.equalsIgnoreCase(word)
                || toString().equalsIgnoreCase(word);
    }

    @Override
    public int compareTo(SensorChannel other) {
        return toString().compareTo(other.toString());
    }

    /** Names it, as {@code sensor/channel}. */
    @Override
    public String toString() {
        return sensor + "/" + channel;
    }
}
