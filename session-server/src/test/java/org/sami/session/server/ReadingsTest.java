package org.sami.session.server;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Base64;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.session.Session;
import org.sami.session.person.PersonRole;
import org.sami.session.server.testing.ServedSession;

/** What a real boat measures, at a front on loopback. */
class ReadingsTest {
    @TempDir
    private Path folder;

    private ServedSession served;
    private Session session;
    private SessionServer server;
    private MeasuringBoat boat;
    private TestFront otto;

    @BeforeEach
    void serve() throws Exception {
        served = ServedSession.ofPlan("station-keep", folder).with("otto", PersonRole.OBSERVER);
        session = served.session();
        server = served.serve();
        served.begin();
        boat = new MeasuringBoat();
        boat.join(session);
        otto = TestFront.loggedIn(server, "otto", "key of otto");
    }

    @AfterEach
    void end() throws Exception {
        boat.close();
        served.close();
    }

    private JsonNode readings() throws Exception {
        return otto.until(message -> message.path("set")
                                .path("readings")
                                .path(0)
                                .path("readings")
                                .size()
                        == 2)
                .path("set")
                .path("readings")
                .get(0);
    }

    @Test
    void observerGetsTheNewestValueOfEachChannel() throws Exception {
        JsonNode row = readings();

        assertThat(row.path("id").asText()).isEqualTo("bella");
        assertThat(row.path("readings").findValuesAsText("channel")).containsExactlyInAnyOrder("oxygen", "temperature");
        assertThat(row.path("readings").findValuesAsText("unit")).containsExactlyInAnyOrder("mg/L", "°C");
        long first = row.path("readings").get(0).path("at").asLong();
        otto.until(message -> message.path("set")
                        .path("readings")
                        .path(0)
                        .path("readings")
                        .path(0)
                        .path("at")
                        .asLong()
                > first);
    }

    @Test
    void layerHasTheCellsWhereSomethingWasMeasured() throws Exception {
        readings();

        otto.send("{\"t\":\"layer\",\"id\":1,\"sensor\":\"temperature\"}");
        JsonNode layer = otto.reply(1).path("layer");

        assertThat(layer.path("unit").asText()).isEqualTo("°C");
        assertThat(layer.path("visualization").asText()).isEqualTo("heatmap");
        assertThat(layer.path("south").asDouble()).isLessThan(45.4 + 1e-4);
        assertThat(layer.path("north").asDouble()).isGreaterThan(45.4 - 1e-4);
        byte[] cells = Base64.getDecoder().decode(layer.path("cells").asText());
        assertThat(cells.length % layer.path("columns").asInt()).isZero();
        assertThat(new String(cells, StandardCharsets.ISO_8859_1)).matches("(?s).*[^\\x00].*");
    }

    @Test
    void layerOfWhatNobodyMeasuresIsRefused() throws Exception {
        readings();

        otto.send("{\"t\":\"layer\",\"id\":1,\"sensor\":\"salt\"}");

        assertThat(otto.reply(1).path("text").asText()).isEqualTo("No boat has measured salt");
    }

    @Test
    void visualizationThatThereIsNotIsNoMessage() throws Exception {
        otto.send("{\"t\":\"layer\",\"id\":1,\"sensor\":\"temperature\",\"visualization\":\"pie\"}");

        assertThat(otto.reply(1).path("bad").asBoolean()).isTrue();
    }
}
