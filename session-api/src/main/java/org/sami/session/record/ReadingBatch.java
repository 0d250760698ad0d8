package org.sami.session.record;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.List;
import org.sami.spn.value.GeoPoint;

/**
 * Readings of one channel of a boat's sensor that are written to the journal as one row: what they have in common is written once. A
 * process that is killed loses the last {@link #LONGEST_MILLIS} of them.
 */
final class ReadingBatch {
    private static final ObjectMapper JSON = new ObjectMapper();
    private static final int MOST = 60;
    private static final long LONGEST_MILLIS = 10_000;
    private static final int FIRST_VALUE = 3;

    /** Of what the readings are. */
    record Channel(String boat, String sensor, String channel, String unit) {}

    private final Channel channel;
    private final List<SensorValue> readings = new ArrayList<>();

    ReadingBatch(Channel channel) {
        this.channel = channel;
    }

    String boat() {
        return channel.boat;
    }

    boolean isEmpty() {
        return readings.isEmpty();
    }

    /** Whether it is to be written before a reading of a moment is added. */
    boolean isDue(long nowMillis) {
        return readings.size() >= MOST
                || (!readings.isEmpty() && nowMillis - readings.get(0).atMillis() >= LONGEST_MILLIS);
    }

    void add(SensorValue reading) {
        readings.add(reading);
    }

    long lastMillis() {
        return readings.get(readings.size() - 1).atMillis();
    }

    /** The row; the batch is empty afterwards. */
    ObjectNode take() {
        ObjectNode json = JSON.createObjectNode()
                .put("sensor", channel.sensor)
                .put("channel", channel.channel)
                .put("unit", channel.unit);
        ArrayNode rows = json.putArray("rows");
        for (SensorValue reading : readings) {
            ArrayNode row = rows.addArray()
                    .add(reading.atMillis())
                    .add(reading.position().latDeg())
                    .add(reading.position().lonDeg());
            reading.values().forEach(row::add);
        }
        readings.clear();
        return json;
    }

    /**
     * Reads a row.
     *
     * @throws IllegalArgumentException if it makes no sense
     */
    static List<SensorValue> read(String boat, JsonNode json) {
        List<SensorValue> readings = new ArrayList<>();
        for (JsonNode row : json.required("rows")) {
            List<Double> values = new ArrayList<>();
            for (int i = FIRST_VALUE; i < row.size(); i++) {
                values.add(row.get(i).asDouble());
            }
            readings.add(new SensorValue(
                    row.required(0).asLong(),
                    boat,
                    json.required("sensor").asText(),
                    json.required("channel").asText(),
                    values,
                    json.required("unit").asText(),
                    GeoPoint.of(row.required(1).asDouble(), row.required(2).asDouble())));
        }
        return readings;
    }
}
