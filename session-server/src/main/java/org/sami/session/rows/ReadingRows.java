package org.sami.session.rows;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import org.sami.crw.operator.map.NewestReading;

/** Rows of the newest readings, made as often as the link has room for them: at most 20 kB/s to each front. For one thread. */
final class ReadingRows {
    private static final long PERIOD_MS = 1000;
    private static final long MS_PER_READING = 6; // a reading is about 100 bytes
    private static final int MOST_CHANNELS = 40; // of a boat
    private static final MathContext DIGITS = new MathContext(5);
    private static final long SECOND_MS = 1000;

    private long dueAtMillis = Long.MIN_VALUE;

    /**
     * The table; empty where it is not time for another.
     *
     * @param newest is asked only when it is time
     */
    Optional<Table> look(Supplier<List<NewestReading>> newest, long nowMillis) {
        if (nowMillis < dueAtMillis) {
            return Optional.empty();
        }
        List<NewestReading> readings = newest.get();
        dueAtMillis = nowMillis + Math.max(PERIOD_MS, MS_PER_READING * readings.size());
        return Optional.of(table(readings));
    }

    private static Table table(List<NewestReading> readings) {
        Table.Builder table = new Table.Builder("readings", BoatRows.MOST_BOATS);
        Map<String, ArrayNode> boats = new HashMap<>();
        for (NewestReading one : readings) {
            ArrayNode list =
                    boats.computeIfAbsent(one.boat(), boat -> table.row(boat).putArray("readings"));
            if (list.size() < MOST_CHANNELS) {
                ObjectNode reading = list.addObject()
                        .put("sensor", Table.Builder.cut(one.channel().sensor()))
                        .put("channel", Table.Builder.cut(one.channel().channel()));
                Table.Builder.put(reading, "unit", one.channel().unit());
                reading.put("value", new BigDecimal(one.value()).round(DIGITS).doubleValue())
                        .put("at", one.atMillis() / SECOND_MS * SECOND_MS);
            }
        }
        return table.build();
    }
}
