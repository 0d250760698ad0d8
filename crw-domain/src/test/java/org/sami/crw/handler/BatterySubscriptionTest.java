package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;

import java.util.List;
import java.util.Map;
import org.assertj.core.groups.Tuple;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.sami.spn.engine.MissionView;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.MissionStatus;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.RealValue;

/** Battery Level Subscription: what missions hear that have thresholds of their own. */
class BatterySubscriptionTest {
    private final ScriptedEngine engine = new ScriptedEngine(TestWorld.VOCABULARY);
    private final TestWorld world = new TestWorld(engine);

    @BeforeEach
    void twoBoatsInTheMission() {
        world.addBoat("a", 0, 0);
        world.addBoat("b", 5, 0);
        world.hull("b").setBatteryPercent(55);
        stand(1, "a", "b");
        world.run(2);
        engine.inputs.clear();
    }

    @Test
    void itIsAnsweredAtOnceForEachBoatByTheThresholdsOfThePlan() {
        subscribe(7, 60, 30, "a", "b");

        assertThat(answers())
                .containsExactly(tuple("BatteryNominal", List.of("a"), 7L), tuple("BatteryLow", List.of("b"), 7L));
    }

    @Test
    void eachChangeOfLevelIsAnsweredOnceAndAChangeWithinALevelIsNot() {
        subscribe(7, 60, 30, "b");
        for (double percent : new double[] {54, 40, 30, 29.9, 10, 30, 59, 60, 61}) {
            world.hull("b").setBatteryPercent(percent);
            world.run(2);
        }

        assertThat(answers())
                .containsExactly(
                        tuple("BatteryLow", List.of("b"), 7L),
                        tuple("BatteryCritical", List.of("b"), 7L),
                        tuple("BatteryLow", List.of("b"), 7L),
                        tuple("BatteryNominal", List.of("b"), 7L));
    }

    @Test
    void aBoatThatLeftThePlaceIsReportedNoLonger() {
        subscribe(7, 60, 30, "a", "b");
        stand(1, "a");
        world.hull("a").setBatteryPercent(50);
        world.hull("b").setBatteryPercent(20);
        world.run(2);

        assertThat(answers().subList(2, answers().size())).containsExactly(tuple("BatteryLow", List.of("a"), 7L));
    }

    @Test
    void afterTheVisitNothingIsAnswered() {
        subscribe(7, 60, 30, "a");
        world.happens(engine, new Effect.ActivationEnded(7));
        world.hull("a").setBatteryPercent(50);
        world.run(2);

        assertThat(answers()).hasSize(1);
    }

    @Test
    void theUpdatePeriodSaysHowOftenALevelIsLookedAt() {
        TestActivations asking = asking(7, 60, 30).with("updatePeriod", new DurationValue(20_000));
        subscribe(asking.of("b"));
        world.hull("b").setBatteryPercent(20);
        world.run(10);
        assertThat(answers()).hasSize(1);

        world.run(11);

        assertThat(answers()).last().isEqualTo(tuple("BatteryCritical", List.of("b"), 7L));
    }

    @Test
    void aLinkThatComesBackRepeatsNothing() {
        subscribe(7, 60, 30, "a", "b");
        world.cutLinks(true);
        world.run(6);
        world.cutLinks(false);
        world.run(6);

        assertThat(answers()).hasSize(2);
    }

    @Test
    void aBaseThatGoesOnRepeatsNothingAndHearsWhatChanged() {
        subscribe(7, 60, 30, "a", "b");
        world.hull("a").setBatteryPercent(20);

        world.host.resume(); // delivers what is open once more, as after a restart of the base
        world.run(2);

        assertThat(answers().subList(2, answers().size())).containsExactly(tuple("BatteryCritical", List.of("a"), 7L));
    }

    /** By its own thresholds the boat turns low at another charge: that concerns only missions that have none of their own. */
    @Test
    void theBoatsOwnClassesGoToTheMissionsWithoutSubscription() {
        stand(2, "a");
        subscribe(7, 1, 0.5, "a");
        engine.inputs.clear();

        world.hull("a").setBatteryPercent(2);
        world.run(2);

        assertThat(engine.received("BatteryCritical"))
                .extracting(Occurrence::mission, Occurrence::proxies)
                .containsExactly(tuple(2L, List.of("a")));
    }

    @Test
    void thresholdsThatMakeNoSenseAreAFailureWithItsReason() {
        subscribe(7, 30, 60, "a");

        assertThat(engine.inputs)
                .filteredOn(Input.HandlerFailed.class::isInstance)
                .singleElement()
                .satisfies(failed -> assertThat(((Input.HandlerFailed) failed).reason())
                        .contains("critical 60.0")
                        .contains("low 30.0"));
    }

    private void subscribe(long id, double low, double critical, String... boats) {
        subscribe(asking(id, low, critical).of(boats));
    }

    private void subscribe(TestActivations asking) {
        engine.open.add(asking.activation());
        world.happens(engine, asking.effect());
    }

    private static TestActivations asking(long id, double low, double critical) {
        return new TestActivations("BatteryLevelSubscription")
                .id(id)
                .with("low", new RealValue(low))
                .with("critical", new RealValue(critical));
    }

    private void stand(long mission, String... boats) {
        List<Token> tokens =
                List.of(boats).stream().<Token>map(Token.Proxy::new).toList();
        engine.missions.put(
                mission,
                new MissionView(mission, 0, mission, "plan", "", MissionStatus.RUNNING, Map.of("here", tokens)));
    }

    private List<Tuple> answers() {
        return engine.inputs.stream()
                .filter(Input.Received.class::isInstance)
                .map(input -> ((Input.Received) input).occurrence())
                .filter(occurrence -> occurrence.type().startsWith("Battery") && occurrence.activation() != 0)
                .map(occurrence -> tuple(occurrence.type(), occurrence.proxies(), occurrence.activation()))
                .toList();
    }
}
