package org.sami.boat.hull.nmea;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.boat.hull.position.GpsFix;

class GpsdReaderTest {
    private final List<GpsFix> fixes = new ArrayList<>();
    private final GpsdReader reader = new GpsdReader(fixes::add);

    @Test
    void positionIsRead() {
        reader.line("{\"class\":\"VERSION\",\"release\":\"3.22\"}");
        reader.line("{\"class\":\"TPV\",\"device\":\"/dev/ttyUSB0\",\"mode\":3,\"time\":\"1970-01-01T00:00:00.000Z\","
                + "\"lat\":45.4,\"lon\":10.9,\"eph\":4.0,\"speed\":1.5,\"track\":180.0}");

        assertThat(fixes).hasSize(1);
        assertThat(fixes.get(0).latDeg()).isEqualTo(45.4);
        assertThat(fixes.get(0).accuracyM()).isEqualTo(2);
        assertThat(fixes.get(0).courseRad()).isEqualTo(Math.PI);
    }

    @Test
    void reportWithoutAFixIsNoPosition() {
        reader.line("{\"class\":\"TPV\",\"mode\":1}");

        assertThat(fixes).isEmpty();
        assertThat(reader.unread()).isZero();
    }

    @Test
    void garbageIsCounted() {
        reader.line("{\"class\":\"TPV\",\"mode\":3,\"lat\":NaN}");
        reader.line("[1]");
        reader.line("[".repeat(1000));

        assertThat(fixes).isEmpty();
        assertThat(reader.unread()).isEqualTo(3);
    }

    @Test
    void missingNumbersAreNoNumbers() {
        reader.line("{\"class\":\"TPV\",\"mode\":2,\"lat\":45.4,\"lon\":\"east\"}");

        assertThat(fixes.get(0).lonDeg()).isNaN();
        assertThat(fixes.get(0).speedMps()).isNaN();
    }
}
