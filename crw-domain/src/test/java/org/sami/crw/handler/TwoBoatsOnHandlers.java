package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.sami.crw.event.ProxyMaps;
import org.sami.crw.message.OperatorMessage;
import org.sami.crw.service.Geodesy;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.TypeCheck;
import org.sami.spn.vocabulary.EventType;

/** Two boats whose requests the real handlers answer; tests look at what comes back to the engine. */
abstract class TwoBoatsOnHandlers {
    final ScriptedEngine engine = new ScriptedEngine(TestWorld.VOCABULARY);
    final TestWorld world = new TestWorld(engine);

    @BeforeEach
    void twoBoats() {
        world.addBoat("west", -100, 0);
        world.addBoat("east", 100, 0);
        world.run(1);
    }

    static void assertFitsVocabulary(Occurrence occurrence) {
        EventType type = TestWorld.VOCABULARY.event(occurrence.type()).orElseThrow();
        occurrence
                .values()
                .forEach((field, value) -> assertThat(TypeCheck.accepts(
                                type.field(field).orElseThrow().type(), value, TestWorld.VOCABULARY.types()))
                        .as(field)
                        .isTrue());
        assertThat(occurrence.values()).hasSameSizeAs(type.fields());
    }

    final Occurrence only(String type) {
        assertThat(engine.received(type)).hasSize(1);
        return engine.received(type).get(0);
    }

    final List<String> messages() {
        return world.operator.messages().messages().stream()
                .map(OperatorMessage::text)
                .toList();
    }

    static GeoPoint point(Occurrence answer, String boat) {
        return ProxyMaps.read(answer.values().get("points"), GeoPoint.class).get(boat);
    }

    static GeoPoint at(double eastM, double northM) {
        return Geodesy.offset(TestWorld.HOME, eastM, northM);
    }
}
