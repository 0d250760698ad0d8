package org.sami.domain.uav;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.sami.spn.analysis.PlanChecks;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.protocol.Question;
import org.sami.spn.testcase.TestCaseRunner;
import org.sami.spn.value.GeoPoint;

/** A second domain beside the boats: its own words, handlers and robots, on the reader, the checks, the engine and the host as they are. */
class UavDomainTest {
    private static final GeoPoint BRIDGE = new GeoPoint(45.601, 10.682, 40);

    private final SimulatedUav kite = new SimulatedUav(45.6, 10.68);
    private final SimulatedUav gull = new SimulatedUav(45.6, 10.6801);
    private UavSession session;

    @BeforeEach
    void twoAircraftOnTheGround() {
        Map<String, SimulatedUav> aircraft = new LinkedHashMap<>();
        aircraft.put("kite", kite);
        aircraft.put("gull", gull);
        session = new UavSession(aircraft);
    }

    @Test
    void plansHaveNoFindingsAndGoAsTheirTestCasesExpect() {
        UavSession.DOMAIN.projects().values().forEach(project -> {
            assertThat(PlanChecks.check(project, UavSession.DOMAIN.vocabulary()))
                    .isEmpty();
            assertThat(new TestCaseRunner(project, UavSession.DOMAIN.vocabulary()).runAll())
                    .isEmpty();
            assertThat(project.plans())
                    .allMatch(plan -> !plan.testCases().isEmpty())
                    .allMatch(plan -> !plan.layout().isEmpty());
        });
    }

    @Test
    void theChosenAircraftFliesToTheLocationTakesItsPictureThereAndLands() {
        start(BRIDGE);
        assertThat(session.decisions())
                .singleElement()
                .extracting(decision -> decision.question())
                .isEqualTo(new Question.ChooseProxies(List.of("kite", "gull"), 1, Integer.MAX_VALUE));
        choose("kite");
        session.fly(5);
        assertThat(kite.position().altM()).isGreaterThan(10);
        session.fly(120);

        assertThat(session.outcomes()).containsExactly(Outcome.ENDED);
        assertThat(session.effects())
                .filteredOn(Effect.VariableWritten.class::isInstance)
                .extracting(effect -> ((Effect.VariableWritten) effect).value())
                .containsExactly(BRIDGE);
        assertThat(kite.position()).isEqualTo(new GeoPoint(BRIDGE.latDeg(), BRIDGE.lonDeg(), 0));
        assertThat(gull.position()).isEqualTo(new GeoPoint(45.6, 10.6801, 0));
    }

    @Test
    void theMissionEndsWhenTheLastOfSeveralIsDown() {
        start(BRIDGE);
        choose("kite", "gull");
        session.fly(120);

        assertThat(session.outcomes()).containsExactly(Outcome.ENDED);
        assertThat(gull.position().altM()).isZero();
        assertThat(gull.position().latDeg()).isEqualTo(BRIDGE.latDeg());
    }

    @Test
    void whatAnAircraftCannotDoIsAnAnswerOfItsOwn() {
        start(new GeoPoint(45.601, 10.682, 500));
        choose("kite");
        session.fly(10);

        assertThat(session.outcomes()).containsExactly(Outcome.ENDED);
        assertThat(kite.position()).isEqualTo(new GeoPoint(45.6, 10.68, 0));
    }

    @Test
    void anAbortLeavesTheAircraftStandingInTheAir() {
        start(BRIDGE);
        choose("kite");
        session.fly(15);
        session.post(new Input.AbortMission(1));
        GeoPoint stands = kite.position();
        session.fly(30);

        assertThat(session.outcomes()).containsExactly(Outcome.ABORTED);
        assertThat(stands.altM()).isEqualTo(BRIDGE.altM());
        assertThat(kite.position()).isEqualTo(stands);
    }

    private void start(GeoPoint location) {
        session.start("look", Map.of("location", location));
    }

    private void choose(String... aircraft) {
        session.answer(new Answer.Proxies(List.of(aircraft)));
    }
}
