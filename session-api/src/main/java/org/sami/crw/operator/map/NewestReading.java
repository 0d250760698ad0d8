package org.sami.crw.operator.map;

import java.util.Objects;
import org.sami.spn.value.GeoPoint;

/**
 * What a boat measured last of one channel.
 *
 * @param value the first of the reading, in the channel's unit
 * @param position where the boat took itself to be
 * @param atMillis when it arrived, on the session's clock
 */
public record NewestReading(String boat, SensorChannel channel, double value, GeoPoint position, long atMillis) {
    public NewestReading {
        Objects.requireNonNull(boat, "boat");
        Objects.requireNonNull(channel, "channel");
        Objects.requireNonNull(position, "position");
    }
}
