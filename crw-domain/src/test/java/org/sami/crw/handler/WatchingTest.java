package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;

import java.util.List;
import java.util.Map;
import org.assertj.core.groups.Tuple;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.sami.crw.message.OperatorMessage;
import org.sami.crw.proxy.status.LinkState;
import org.sami.crw.service.Geodesy;
import org.sami.spn.engine.MissionView;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.MissionStatus;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.vocabulary.EventType;

/** Areas that boats enter and leave, readings of their sensors, and links that plans cut: on real boat servers. */
class WatchingTest {
    /** 20 m to 60 m east of home, 20 m to either side, without a hole of 4 m around its middle. */
    private static final GeoArea AREA = new GeoArea(
            List.of(at(20, -20), at(60, -20), at(60, 20), at(20, 20)),
            List.of(List.of(at(36, -4), at(44, -4), at(44, 4), at(36, 4))));

    private final ScriptedEngine engine = new ScriptedEngine(TestWorld.VOCABULARY);
    private final TestWorld world = new TestWorld(engine);

    @BeforeEach
    void twoBoats() {
        world.addBoat("a", 0, 0);
        world.addBoat("b", 25, 10, hull -> hull.measures("ctd", "temperature", 17.5));
        stand("a", "b");
        world.run(1);
    }

    @Test
    void aBoatThatIsInTheAreaIsToldAtOnceAndOneThatIsNotWhenItEnters() {
        happens(subscription());
        assertThat(news()).containsExactly(tuple("ProxyEnteredArea", List.of("b")));
        world.run(5);
        assertThat(news()).hasSize(1);

        world.hull("a").drift(30, 10);
        world.run(1);
        world.hull("b").drift(-15, 0);
        world.run(1);

        assertThat(news())
                .containsExactly(
                        tuple("ProxyEnteredArea", List.of("b")),
                        tuple("ProxyEnteredArea", List.of("a")),
                        tuple("ProxyLeftArea", List.of("b")));
        assertThat(engine.received("ProxyLeftArea").get(0).activation()).isEqualTo(7);
    }

    @Test
    void aHoleIsNotInTheArea() {
        happens(subscription());
        world.hull("b").drift(15, -10);
        world.run(1);

        assertThat(news()).endsWith(tuple("ProxyLeftArea", List.of("b")));
    }

    @Test
    void aBoatThatHasLeftThePlaceIsWatchedNoLonger() {
        happens(subscription());
        stand("a");
        world.hull("b").drift(-20, 0);
        world.run(1);
        world.happens(engine, new Effect.ActivationEnded(7));
        world.hull("a").drift(30, 10);
        world.run(1);

        assertThat(news()).containsExactly(tuple("ProxyEnteredArea", List.of("b")));
    }

    @Test
    void aBaseThatGoesOnDoesNotRepeatWhereBoatsAre() {
        happens(subscription());
        engine.open.add(subscription().activation());

        world.host.resume();
        world.run(2);

        assertThat(news()).containsExactly(tuple("ProxyEnteredArea", List.of("b")));
    }

    @Test
    void theNextReadingOfTheSensorAnswersOnce() {
        happens(measurement("temperature").of("b"));
        assertThat(engine.received("MeasurementTaken")).isEmpty();
        world.run(5);

        assertThat(engine.received("MeasurementTaken")).singleElement().satisfies(answer -> {
            assertThat(answer.proxies()).containsExactly("b");
            assertThat(answer.values()).containsEntry("value", new RealValue(17.5));
            assertThat(Geodesy.distanceM((GeoPoint) answer.values().get("location"), at(25, 10)))
                    .isLessThan(1);
            EventType type = TestWorld.VOCABULARY.event("MeasurementTaken").orElseThrow();
            assertThat(answer.values())
                    .containsOnlyKeys(
                            type.fields().stream().map(field -> field.name()).toList());
        });
    }

    @Test
    void aSensorIsNamedByItsInstrumentAsWellAndTheOperatorHearsOfOneThatIsNotThere() {
        happens(measurement("ctd/temperature").of("b"));
        happens(measurement("oxygen").id(8).of("b"));
        happens(measurement("oxygen").id(9).of("a"));
        world.run(90);

        assertThat(engine.received("MeasurementTaken"))
                .extracting(Occurrence::activation)
                .containsExactly(7L);
        assertThat(world.operator.messages().messages())
                .extracting(OperatorMessage::text)
                .filteredOn(text -> text.contains("oxygen"))
                .satisfiesExactlyInAnyOrder(
                        text -> assertThat(text).startsWith("b ").contains("it has ctd/temperature"),
                        text -> assertThat(text).startsWith("a ").contains("no reading at all"));
    }

    @Test
    void aLinkThatIsCutKeepsTheCommandUntilItIsTakenUpAgain() {
        GeoPoint far = at(0, 120);
        happens(new TestActivations("ProxyGotoLatLon")
                .id(2)
                .with("location", far)
                .of("a"));
        world.run(10);
        happens(new TestActivations("DisconnectServer").id(3).of("a"));
        world.run(10);
        assertThat(link("a")).isEqualTo(LinkState.LOST);
        assertThat(link("b")).isEqualTo(LinkState.LINKED);
        GeoPoint held = world.hull("a").position();
        world.run(30);
        assertThat(Geodesy.distanceM(held, world.hull("a").position())).isLessThan(6);
        assertThat(world.boats.find("a").orElseThrow().explain().text()).contains("cut on purpose");
        assertThat(engine.received("ProxyPathCompleted")).isEmpty();

        happens(new TestActivations("ReconnectServer").id(4).of("a"));
        world.run(90);

        assertThat(Geodesy.distanceM(world.hull("a").position(), far)).isLessThan(6);
        assertThat(engine.received("ProxyPathCompleted"))
                .extracting(Occurrence::activation)
                .containsExactly(2L);
    }

    private static TestActivations subscription() {
        return new TestActivations("ProxyAreaSubscription").with("area", AREA).of("a", "b");
    }

    private static TestActivations measurement(String sensor) {
        return new TestActivations("TakeMeasurement").with("sensor", new TextValue(sensor));
    }

    /** These boats stand in the place of the activations. */
    private void stand(String... boats) {
        List<Token> tokens =
                List.of(boats).stream().<Token>map(Token.Proxy::new).toList();
        engine.missions.put(1L, new MissionView(1, 0, 1, "plan", "", MissionStatus.RUNNING, Map.of("here", tokens)));
    }

    private void happens(TestActivations asking) {
        world.happens(engine, asking.effect());
    }

    private List<Tuple> news() {
        return engine.inputs.stream()
                .filter(Input.Received.class::isInstance)
                .map(input -> ((Input.Received) input).occurrence())
                .filter(occurrence -> occurrence.type().endsWith("Area"))
                .map(occurrence -> tuple(occurrence.type(), occurrence.proxies()))
                .toList();
    }

    private LinkState link(String boat) {
        return world.boats.find(boat).orElseThrow().status().link();
    }

    private static GeoPoint at(double eastM, double northM) {
        return Geodesy.offset(TestWorld.HOME, eastM, northM);
    }
}
