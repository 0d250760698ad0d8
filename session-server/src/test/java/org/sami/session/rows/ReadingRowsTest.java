package org.sami.session.rows;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.crw.operator.map.NewestReading;
import org.sami.crw.operator.map.SensorChannel;
import org.sami.spn.value.GeoPoint;

/** How often a front gets readings. */
class ReadingRowsTest {
    private static final GeoPoint HERE = GeoPoint.of(45.7, 10.72);

    private final ReadingRows rows = new ReadingRows();

    private static NewestReading reading(String boat, String channel, double value, long atMillis) {
        return new NewestReading(boat, new SensorChannel(channel, channel, "µS/cm"), value, HERE, atMillis);
    }

    /** What boats measure ten times a second, each time something else. */
    private static List<NewestReading> measured(int boats, int channels, long atMillis) {
        List<NewestReading> all = new ArrayList<>();
        for (int boat = 1; boat <= boats; boat++) {
            for (int channel = 1; channel <= channels; channel++) {
                all.add(reading("simulated" + boat, "conductivity" + channel, 400 + atMillis / 7e4 + boat, atMillis));
            }
        }
        return all;
    }

    private double kilobytesPerSecond(int boats, int channels) {
        SentRows front = new SentRows();
        long bytes = 0;
        int seconds = 120;
        for (long now = 0; now < seconds * 1000L; now += 100) {
            long at = now;
            Optional<Table> table = rows.look(() -> measured(boats, channels, at), now);
            if (table.isPresent()) {
                bytes += front.changes(List.of(table.get()), now)
                        .map(message -> message.toString().getBytes(StandardCharsets.UTF_8).length)
                        .orElse(0);
            }
        }
        return bytes / 1000.0 / seconds;
    }

    @Test
    void aLargeFleetsReadingsLeaveRoomForItsPositions() {
        assertThat(kilobytesPerSecond(250, 4)).isBetween(5.0, 22.0);
    }

    @Test
    void manyChannelsTakeNoMoreThanFew() {
        assertThat(kilobytesPerSecond(250, 40)).isLessThan(22.0);
    }

    @Test
    void aSmallFleetsReadingsAreASecondOld() {
        assertThat(rows.look(() -> measured(3, 2, 0), 0)).isPresent();
        assertThat(rows.look(() -> measured(3, 2, 900), 900)).isEmpty();
        Table table = rows.look(() -> measured(3, 2, 1000), 1000).orElseThrow();

        assertThat(table.rows()).containsOnlyKeys("simulated1", "simulated2", "simulated3");
        assertThat(table.rows().get("simulated1").path("readings").get(0).toString())
                .isEqualTo("{\"sensor\":\"conductivity1\",\"channel\":\"conductivity1\",\"unit\":\"µS/cm\","
                        + "\"value\":401.01,\"at\":1000}");
    }
}
