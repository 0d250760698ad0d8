package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/** Plans that bring boats into the base. */
class ConnectTest {
    private static final String RED = "RED at 192.168.1.105:11411";

    private final ScriptedEngine engine = new ScriptedEngine(TestWorld.VOCABULARY);
    private final TestWorld world = new TestWorld(engine);

    private static TestActivations connect(String server) {
        return new TestActivations("ConnectExistingProxy")
                .with("name", new TextValue("RED"))
                .with("color", new TextValue("#f40000"))
                .with("server", new TextValue(server));
    }

    @Test
    void aConnectedBoatJoinsAndThenAnswersThePlanAndIsNewsToAllOthers() {
        world.happens(engine, connect("192.168.1.105:11411").effect());

        world.run(1);

        assertThat(engine.proxies()).containsExactly(RED);
        Occurrence answer = engine.received("ProxyCreated").get(0);
        assertThat(engine.received("ProxyCreated")).hasSize(1);
        assertThat(answer.proxies()).containsExactly(RED);
        assertThat(answer.activation()).isNotEqualTo(Ids.NONE);
        assertThat(answer.mission()).isEqualTo(Ids.NONE);
        assertThat(indexOf(new Input.ProxyJoined(RED))).isLessThan(indexOf(new Input.Received(answer)));
    }

    private int indexOf(Input input) {
        return engine.inputs.indexOf(input);
    }

    @Test
    void aBoatThatIsThereAlreadyAnswersAtOnceAndIsNoNewsToOthers() {
        world.happens(engine, connect("192.168.1.105:11411").effect());
        world.run(1);

        world.happens(engine, connect("192.168.1.105:11411").effect());

        assertThat(engine.received("ProxyCreated")).hasSize(2);
        Occurrence second = engine.received("ProxyCreated").get(1);
        assertThat(second.mission()).isNotEqualTo(Ids.NONE);
        assertThat(engine.proxies()).containsExactly(RED);
    }

    @Test
    void aBoatIsConnectedByItsId() {
        Map<String, Value> id = new LinkedHashMap<>();
        id.put("name", new TextValue("RED"));
        id.put("color", new TextValue("#f40000"));
        id.put("server", new TextValue("192.168.1.105:11411"));
        id.put("imageStorageDirectory", new TextValue(""));

        world.happens(
                engine,
                new TestActivations("ConnectExistingProxyId")
                        .with("boatId", new RecordValue("BoatId", id))
                        .effect());
        world.run(1);

        assertThat(engine.received("ProxyCreated")).map(Occurrence::proxies).containsExactly(List.of(RED));
    }

    @Test
    void simulatedBoatsAnswerTogetherWhenTheLastHasJoined() {
        world.happens(
                engine,
                new TestActivations("CreateSimulatedProxy")
                        .with("name", new TextValue("Sim"))
                        .with("color", new TextValue("#ffffff"))
                        .with("startLocation", TestWorld.HOME)
                        .with("numberToCreate", new IntegerValue(3))
                        .effect());
        world.run(1);

        assertThat(engine.proxies()).containsExactly("Sim0", "Sim1", "Sim2");
        assertThat(engine.received("ProxyCreated"))
                .map(Occurrence::proxies)
                .containsExactly(List.of("Sim0", "Sim1", "Sim2"));
    }

    @Test
    void whatCannotBeConnectedToIsAFailureThatSaysWhy() {
        world.happens(engine, connect(TestWorld.NOWHERE).effect());
        world.run(1);

        assertThat(engine.inputs)
                .filteredOn(Input.HandlerFailed.class::isInstance)
                .singleElement()
                .satisfies(failed -> assertThat(failed.toString()).contains("nobody can be at nowhere:0"));
        assertThat(engine.received("ProxyCreated")).isEmpty();
    }
}
