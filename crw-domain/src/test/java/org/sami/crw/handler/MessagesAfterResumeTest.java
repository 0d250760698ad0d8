package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.sami.crw.message.OperatorMessage;
import org.sami.spn.engine.MissionView;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.MissionStatus;
import org.sami.spn.value.TextValue;

/** Messages of plans under a base that goes on with their mission: the visits go on, and the activations are delivered again. */
class MessagesAfterResumeTest {
    private final ScriptedEngine engine = new ScriptedEngine(TestWorld.VOCABULARY);
    private TestWorld world = new TestWorld(engine);

    @BeforeEach
    void aMission() {
        engine.missions.put(1L, new MissionView(1, 0, 1, "plan", "", MissionStatus.RUNNING, Map.of()));
    }

    private static Activation message(long id, String text) {
        return new TestActivations("DisplayMessage")
                .id(id)
                .with("message", new TextValue(text))
                .activation();
    }

    private static Activation unknown(long id, String name) {
        return new TestActivations("UnknownRequest")
                .id(id)
                .with("class", new TextValue(name))
                .activation();
    }

    private void asks(Activation activation) {
        engine.open.add(activation);
        world.happens(engine, new Effect.Activated(activation));
    }

    private void resume() {
        world.drain();
        world = new TestWorld(engine);
        world.host.resume();
        world.drain();
    }

    private List<String> shown() {
        return world.operator.messages().messages().stream()
                .map(OperatorMessage::text)
                .toList();
    }

    @Test
    void aMessageThatWasShownIsNotShownAgainUnlessItIsOrdered() {
        asks(message(7, "go to the pier"));
        assertThat(shown()).containsExactly("go to the pier");

        resume();
        assertThat(shown()).isEmpty();

        world.host.redeliver(7);
        world.drain();
        assertThat(shown()).containsExactly("go to the pier");
    }

    @Test
    void anUnknownRequestThatWasToldIsNotToldAgain() {
        asks(unknown(7, "org.example.Dive"));
        assertThat(shown()).singleElement().asString().contains("org.example.Dive");

        resume();

        assertThat(shown()).isEmpty();
    }

    @Test
    void aMessageThatWasNotShownIsShownUnderTheNextBaseBesideOneThatWas() {
        asks(unknown(6, "org.example.Dive"));
        asks(message(7, "go to the pier"));
        engine.open.add(message(8, "take her out"));

        resume();

        assertThat(shown()).containsExactly("take her out");
    }
}
