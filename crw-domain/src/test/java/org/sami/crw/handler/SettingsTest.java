package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;

import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.Gains;
import org.sami.crw.decision.BoatDescriptions;
import org.sami.crw.message.OperatorMessage;
import org.sami.crw.proxy.status.BoatTuning;
import org.sami.crw.service.Geodesy;
import org.sami.spn.engine.MissionView;
import org.sami.spn.protocol.MissionStatus;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.TextValue;

/** Settings on their way from a plan to a real boat server, and what the plan hears of them. */
class SettingsTest {
    private final ScriptedEngine engine = new ScriptedEngine(TestWorld.VOCABULARY);
    private TestWorld world = new TestWorld(engine);

    @BeforeEach
    void twoBoats() {
        engine.missions.put(
                1L,
                new MissionView(
                        1, 0, 1, "plan", "", MissionStatus.RUNNING, Map.of("here", List.of(new Token.Proxy("a")))));
        for (String set : List.of("SetGains", "SetVelocityMultiplier")) {
            engine.awaited.addAll(List.of(set + "Succeeded", set + "Failed"));
        }
        world.addBoat("a", 0, 0);
        world.addBoat("b", 5, 0);
        world.run(1);
    }

    @Test
    void gainsAreInForceOnEachBoatWhenItAnswers() {
        world.cutLinks(true);
        happens(gains(0.5, 2));
        assertThat(engine.received("SetGainsSucceeded")).isEmpty();
        world.cutLinks(false);
        world.run(3);

        assertThat(engine.received("SetGainsSucceeded"))
                .extracting(Occurrence::proxies, Occurrence::activation)
                .containsExactlyInAnyOrder(tuple(List.of("a"), 7L), tuple(List.of("b"), 7L));
        for (String boat : List.of("a", "b")) {
            BoatTuning tuning =
                    world.boats.find(boat).orElseThrow().settings().inForce().orElseThrow();
            assertThat(tuning.heading()).isEqualTo(new Gains(0.5, 0.25, 0.125));
            assertThat(tuning.speed()).isEqualTo(new Gains(2, 1, 0.5));
        }
    }

    @Test
    void gainsThatNoBoatTakesFailWithAReasonAndNothingIsSet() {
        BoatTuning before =
                world.boats.find("a").orElseThrow().settings().inForce().orElseThrow();
        happens(gains(0.5, -2));
        world.run(1);

        assertThat(engine.received("SetGainsSucceeded")).isEmpty();
        assertThat(engine.received("SetGainsFailed"))
                .hasSize(2)
                .allSatisfy(failed -> assertThat(((TextValue) failed.values().get("reason")).value())
                        .contains("-2"));
        assertThat(world.boats.find("a").orElseThrow().settings().inForce()).contains(before);
        assertThat(world.operator.messages().messages())
                .extracting(OperatorMessage::text)
                .anyMatch(text -> text.startsWith("a has not taken over what \"here\" set"));
    }

    @Test
    void aBoatUnderWayIsSlowedDown() {
        GeoPoint far = Geodesy.offset(TestWorld.HOME, 0, 300);
        happens(new TestActivations("ProxyGotoLatLon").with("location", far).of("a"));
        world.run(20);
        double usual = world.hull("a").speedMps();

        happens(new TestActivations("SetVelocityMultiplier")
                .id(8)
                .with("multiplier", new RealValue(0.25))
                .of("a"));
        world.run(20);

        assertThat(world.hull("a").speedMps()).isBetween(0.15 * usual, 0.35 * usual);
        assertThat(engine.received("SetVelocityMultiplierSucceeded"))
                .extracting(Occurrence::proxies)
                .containsExactly(List.of("a"));
    }

    @Test
    void aMultiplierThatIsTooLargeFails() {
        happens(new TestActivations("SetVelocityMultiplier")
                .with("multiplier", new RealValue(1000))
                .of("a", "ghost"));

        assertThat(engine.received("SetVelocityMultiplierFailed"))
                .extracting(Occurrence::proxies)
                .containsExactly(List.of("a"), List.of("ghost"));
    }

    @Test
    void aSettingWaitsForALostLinkAndANewerOneTakesItsPlace() {
        world.cutLinks(true);
        world.run(6);
        happens(new TestActivations("SetVelocityMultiplier")
                .id(8)
                .with("multiplier", new RealValue(0.5))
                .of("a"));
        happens(new TestActivations("SetVelocityMultiplier")
                .id(9)
                .with("multiplier", new RealValue(0.75))
                .of("a"));
        world.run(30);
        assertThat(engine.received("SetVelocityMultiplierFailed"))
                .extracting(Occurrence::activation)
                .containsExactly(8L);
        assertThat(engine.received("SetVelocityMultiplierSucceeded")).isEmpty();

        world.cutLinks(false);
        world.run(6);

        assertThat(engine.received("SetVelocityMultiplierSucceeded"))
                .extracting(Occurrence::activation)
                .containsExactly(9L);
        assertThat(world.boats
                        .find("a")
                        .orElseThrow()
                        .settings()
                        .inForce()
                        .orElseThrow()
                        .velocityMultiplier())
                .isEqualTo(0.75);
    }

    private void asksForHalf() {
        TestActivations asking = new TestActivations("SetVelocityMultiplier")
                .with("multiplier", new RealValue(0.5))
                .of("a");
        engine.open.add(asking.activation());
        happens(asking);
    }

    /** Another process of the base goes on. */
    private void resume() {
        world.drain();
        world = new TestWorld(engine);
        world.addBoat("a", 0, 0);
        world.host.resume();
        world.run(3);
    }

    private double multiplier() {
        return world.boats
                .find("a")
                .orElseThrow()
                .settings()
                .inForce()
                .orElseThrow()
                .velocityMultiplier();
    }

    private List<Occurrence> answers() {
        return Stream.concat(
                        engine.received("SetVelocityMultiplierSucceeded").stream(),
                        engine.received("SetVelocityMultiplierFailed").stream())
                .toList();
    }

    @Test
    void aSettingThatWasAnsweredIsNotSetAgainUnderTheNextBaseUnlessItIsOrdered() {
        asksForHalf();
        world.run(2);
        assertThat(answers()).hasSize(1);

        resume();

        assertThat(multiplier()).as("what the boat has otherwise").isEqualTo(1);
        assertThat(answers()).as("told once").hasSize(1);
        world.cutLinks(true);
        world.host.redeliver(7);
        world.drain();
        resume();
        assertThat(multiplier()).as("ordered before the restart").isEqualTo(0.5);
        assertThat(answers()).hasSize(2);
    }

    @Test
    void aSettingThatFailedIsNotSetUnderTheNextBase() {
        world.cutLinks(true);
        asksForHalf();
        world.boats.find("a").orElseThrow().settings().setVelocityMultiplier(0.75);
        world.drain();
        assertThat(engine.received("SetVelocityMultiplierFailed")).hasSize(1);

        resume();

        assertThat(multiplier()).isEqualTo(1);
        assertThat(answers()).hasSize(1);
    }

    @Test
    void aSettingThatTheBoatHasNotAnsweredIsSetUnderTheNextBase() {
        world.cutLinks(true);
        asksForHalf();

        resume();

        assertThat(multiplier()).isEqualTo(0.5);
        assertThat(answers()).hasSize(1);
    }

    @Test
    void aSettingThatStillWaitsIsNotReplacedByItselfWhenItIsOrderedAgain() {
        world.cutLinks(true);
        asksForHalf();
        world.host.redeliver(7);
        world.drain();
        assertThat(answers()).isEmpty();

        world.cutLinks(false);
        world.run(3);

        assertThat(engine.received("SetVelocityMultiplierSucceeded")).hasSize(1);
        assertThat(answers()).hasSize(1);
    }

    @Test
    void aDescriptionThatWasChangedSinceIsNotSetBackUnderTheNextBase() {
        TestActivations first = new TestActivations("ProxySetDescription").with("description", new TextValue("SHORE"));
        engine.open.add(first.of("a").activation());
        happens(first);
        happens(new TestActivations("ProxySetDescription")
                .id(8)
                .with("description", new TextValue("WATER"))
                .of("a"));

        resume();
        assertThat(BoatDescriptions.of(engine, "a")).contains("WATER");

        world.host.redeliver(7);
        world.drain();
        assertThat(BoatDescriptions.of(engine, "a")).as("ordered").contains("SHORE");
    }

    private void happens(TestActivations asking) {
        world.happens(engine, asking.effect());
    }

    private static TestActivations gains(double rudder, double thrust) {
        return new TestActivations("SetGains")
                .with("rudderP", new RealValue(rudder))
                .with("rudderI", new RealValue(rudder / 2))
                .with("rudderD", new RealValue(rudder / 4))
                .with("thrustP", new RealValue(thrust))
                .with("thrustI", new RealValue(thrust / 2))
                .with("thrustD", new RealValue(thrust / 4))
                .of("a", "b");
    }
}
