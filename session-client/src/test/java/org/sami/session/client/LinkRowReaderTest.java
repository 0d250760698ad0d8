package org.sami.session.client;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.spn.value.GeoPoint;

/** Rows of robots as a session elsewhere sends them. */
class LinkRowReaderTest {
    private static GeoPoint place(String height) throws Exception {
        JsonNode row = new ObjectMapper()
                .readTree("{\"id\":\"c1\",\"lat\":45.7,\"lon\":10.72" + height
                        + ",\"link\":\"linked\",\"commander\":\"this-base\",\"why\":\"\"}");
        return LinkRowReader.boat(row, 0, Optional.empty())
                .orElseThrow()
                .pose()
                .orElseThrow()
                .position();
    }

    @Test
    void copterIsAsHighAsItsRowSays() throws Exception {
        assertThat(place(",\"alt\":29.8")).isEqualTo(new GeoPoint(45.7, 10.72, 29.8));
    }

    @Test
    void robotWhoseRowSaysNoHeightIsOnTheGround() throws Exception {
        assertThat(place("")).isEqualTo(GeoPoint.of(45.7, 10.72));
    }
}
