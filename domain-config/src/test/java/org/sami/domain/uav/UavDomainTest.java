package org.sami.domain.uav;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.sami.spn.analysis.PlanChecks;
import org.sami.spn.engine.Engine;
import org.sami.spn.finding.Severity;
import org.sami.spn.host.EngineHost;
import org.sami.spn.host.HostClock;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.GeoPoint;

/** A second domain beside the boats: its own words, handlers and robots, on the reader, the checks, the engine and the host as they are. */
class UavDomainTest implements HostClock {
    private static final DomainLibrary DOMAIN =
            DomainLibrary.fromClassPath("/org/sami/domain/uav").orThrow();
    private static final Project PROJECT = DOMAIN.projectOf("look").orElseThrow();
    private static final GeoPoint BRIDGE = new GeoPoint(45.601, 10.682, 40);

    private final Queue<Runnable> work = new ArrayDeque<>();
    private final List<Effect> effects = new ArrayList<>();
    private final Flight flight = new Flight();
    private final SimulatedUav kite = new SimulatedUav(45.6, 10.68);
    private final SimulatedUav gull = new SimulatedUav(45.6, 10.6801);
    private EngineHost host;
    private long nowMs;
    private long wakeMs = Long.MAX_VALUE;
    private Runnable wake = () -> {};

    @BeforeEach
    void twoAircraftOnTheGround() {
        Engine engine = new Engine(DOMAIN.vocabulary(), PROJECT);
        host = EngineHost.builder(engine, engine.newState())
                .clock(this)
                .executor(work::add)
                .build();
        host.addListener((index, atMillis, input, stepped, view) -> effects.addAll(stepped));
        flight.add("kite", kite);
        flight.add("gull", gull);
        flight.install(host);
        post(new Input.ProxyJoined("kite"));
        post(new Input.ProxyJoined("gull"));
    }

    @Test
    void thePlanHasNoFindings() {
        assertThat(PlanChecks.check(PROJECT, DOMAIN.vocabulary()))
                .noneMatch(finding -> finding.severity() == Severity.ERROR);
    }

    @Test
    void theChosenAircraftFliesToTheLocationTakesItsPictureThereAndLands() {
        start(BRIDGE);
        assertThat(question()).isEqualTo(new Question.ChooseProxies(List.of("kite", "gull"), 1, Integer.MAX_VALUE));
        choose("kite");
        fly(5);
        assertThat(kite.position().altM()).isGreaterThan(10);
        fly(120);

        assertThat(outcomes()).containsExactly(Outcome.ENDED);
        assertThat(effects)
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
        fly(120);

        assertThat(outcomes()).containsExactly(Outcome.ENDED);
        assertThat(gull.position().altM()).isZero();
        assertThat(gull.position().latDeg()).isEqualTo(BRIDGE.latDeg());
    }

    @Test
    void whatAnAircraftCannotDoIsAnAnswerOfItsOwn() {
        start(new GeoPoint(45.601, 10.682, 500));
        choose("kite");
        fly(10);

        assertThat(outcomes()).containsExactly(Outcome.ENDED);
        assertThat(kite.position()).isEqualTo(new GeoPoint(45.6, 10.68, 0));
    }

    @Test
    void anAbortLeavesTheAircraftStandingInTheAir() {
        start(BRIDGE);
        choose("kite");
        fly(15);
        post(new Input.AbortMission(1));
        GeoPoint stands = kite.position();
        fly(30);

        assertThat(outcomes()).containsExactly(Outcome.ABORTED);
        assertThat(stands.altM()).isEqualTo(BRIDGE.altM());
        assertThat(kite.position()).isEqualTo(stands);
    }

    private void start(GeoPoint location) {
        post(new Input.StartMission("look", "bridge", Map.of("location", location)));
    }

    private Question question() {
        return decision().question();
    }

    private Decision decision() {
        List<Decision> open = host.ask(view -> view.decisions());
        assertThat(open).hasSize(1);
        return open.get(0);
    }

    private void choose(String... aircraft) {
        post(new Input.AnswerDecision(decision().id(), new Answer.Proxies(List.of(aircraft)), Answerer.OPERATOR));
    }

    private void fly(int seconds) {
        for (int tenth = 0; tenth < 10 * seconds; tenth++) {
            nowMs += 100;
            if (nowMs >= wakeMs) {
                wakeMs = Long.MAX_VALUE;
                wake.run();
            }
            flight.step(0.1);
            drain();
        }
    }

    private void post(Input input) {
        host.post(input);
        drain();
    }

    private void drain() {
        for (Runnable next = work.poll(); next != null; next = work.poll()) {
            next.run();
        }
    }

    private List<Outcome> outcomes() {
        return effects.stream()
                .filter(Effect.MissionEnded.class::isInstance)
                .map(effect -> ((Effect.MissionEnded) effect).outcome())
                .toList();
    }

    @Override
    public long nowMillis() {
        return nowMs;
    }

    @Override
    public void wakeAt(long millis, Runnable action) {
        wakeMs = millis;
        wake = action;
    }
}
