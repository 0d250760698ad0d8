package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.decision.DefaultAnswers;
import org.sami.crw.decision.SimulatedOperator;
import org.sami.crw.message.OperatorMessage;
import org.sami.crw.operator.decision.PendingDecision;
import org.sami.crw.service.Geodesy;
import org.sami.spn.engine.MissionView;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;

/** The plans of the library, and one with a button, with everything real but the hulls: engine, host, handlers, proxies, boat servers. */
class PlansOnBoatsTest {
    private static final DomainLibrary LIBRARY =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
    private static final long ANSWER_AFTER_MS = 5000;

    private final List<Effect> effects = new CopyOnWriteArrayList<>();
    private final Set<Long> answered = new HashSet<>();
    private TestWorld world;
    private SimulatedOperator operator;

    @ParameterizedTest
    @CsvSource({"1,1", "3,20", "5,30", "4,0"})
    void theBoatsVisitEveryLocationAndTheMissionEnds(int boats, int locations) {
        start("clv", boats, locations);
        runFor(20);
        Set<GeoPoint> left = new LinkedHashSet<>(marked());
        assertThat(left).hasSize(locations);

        for (int tick = 0; tick < 18_000 && outcome().isEmpty(); tick++) {
            runFor(0.2);
            left.removeIf(this::isVisited);
        }

        assertThat(left).isEmpty();
        assertThat(outcome()).contains(Outcome.ENDED);
        assertThat(problems()).isEmpty();
        assertThat(world.operator.clicks().clicks()).isEqualTo(1 + boats + 1 + locations + 1 + 1);
        assertThat(world.operator.messages().messages())
                .extracting(OperatorMessage::text)
                .contains("All boats have finished");
    }

    @Test
    void stationsAreKeptUntilTheOperatorHasEnough() {
        start("station-keep", 3, 0);

        for (int second = 0; second < 1800 && outcome().isEmpty(); second++) {
            runFor(1);
        }

        assertThat(outcome()).contains(Outcome.ENDED);
        assertThat(problems()).isEmpty();
        assertApart(3, 5);
        runFor(10);
        assertThat(world.hull("boat-1").isAtRest()).isTrue();
    }

    @ParameterizedTest
    @ValueSource(ints = {6, 12, 17, 23, 40, 90})
    void anAbortAtAnyMomentLeavesEveryBoatStopped(int second) {
        start("clv", 3, 20);
        runFor(second);

        world.host.post(new Input.AbortMission(1));
        runFor(10);

        assertThat(outcome()).contains(Outcome.ABORTED);
        for (String boat : world.boats.boatIds()) {
            assertThat(world.hull(boat).isAtRest()).as(boat).isTrue();
            assertThat(world.boats.find(boat).orElseThrow().commands().current())
                    .isEmpty();
        }
    }

    @Test
    void anEngineOnAThreadOfItsOwnChangesNothing() throws InterruptedException {
        ExecutorService thread = Executors.newSingleThreadExecutor();
        try {
            start("clv", 3, 20, Optional.of(thread));

            for (int second = 0; second < 20_000 && outcome().isEmpty(); second++) {
                runFor(1);
            }

            assertThat(outcome()).contains(Outcome.ENDED);
            assertThat(problems()).isEmpty();
        } finally {
            thread.shutdown();
            assertThat(thread.awaitTermination(60, TimeUnit.SECONDS)).isTrue();
        }
    }

    @Test
    void aPathThatAButtonInterruptsGoesOnAtItsFirstUnvisitedLocation() throws IOException {
        String text = new String(
                PlansOnBoatsTest.class.getResourceAsStream("paused-visit.json").readAllBytes(), StandardCharsets.UTF_8);
        Project project =
                new ProjectReader(TestWorld.VOCABULARY).readAndCheck(text).orThrow();
        start(project, "paused-visit", 1, 0, Optional.empty());
        TestHull hull = world.hull("boat-1");
        GeoPoint second = Geodesy.offset(TestWorld.HOME, 0, 60);
        for (int tick = 0; tick < 2000 && Geodesy.distanceM(hull.position(), second) > 2; tick++) {
            runFor(0.1);
        }
        runFor(5);

        world.host.post(new Input.Interrupt(1, "Pause", List.of()));
        runFor(3);
        assertThat(hull.isAtRest()).isTrue();
        GeoPoint paused = hull.position();
        double furthestBackM = 0;
        for (int tick = 0; tick < 3000 && outcome().isEmpty(); tick++) {
            runFor(0.1);
            double northM = (hull.position().latDeg() - paused.latDeg()) * 111_130;
            furthestBackM = Math.max(furthestBackM, -northM);
        }

        assertThat(outcome()).contains(Outcome.ENDED);
        assertThat(furthestBackM).isLessThan(5);
        assertThat(problems()).isEmpty();
    }

    private void start(String plan, int boats, int locations) {
        start(plan, boats, locations, Optional.empty());
    }

    private void start(String plan, int boats, int locations, Optional<Executor> enginesOwn) {
        Project project = LIBRARY.projects().values().stream()
                .filter(candidate -> candidate.plan(plan).isPresent())
                .findFirst()
                .orElseThrow();
        start(project, plan, boats, locations, enginesOwn);
    }

    private void start(Project project, String plan, int boats, int locations, Optional<Executor> enginesOwn) {
        world = new TestWorld(new HostedEngine(project), enginesOwn);
        world.host.addListener((index, atMillis, input, stepped, view) -> effects.addAll(stepped));
        operator = new SimulatedOperator(
                TestWorld.VOCABULARY, new DefaultAnswers(TestWorld.HOME, 200, locations, 42), AnswersFile.EMPTY);
        for (int boat = 1; boat <= boats; boat++) {
            world.addBoat("boat-" + boat, 4.0 * boat, 0);
        }
        world.run(2);
        world.host.post(new Input.StartMission(plan, "test", Map.of()));
    }

    private void runFor(double seconds) {
        for (int tick = 0; tick < Math.round(seconds * 10); tick++) {
            world.run(0.1);
            for (PendingDecision pending : world.operator.decisions().pending()) {
                if (world.nowMillis() - pending.openedAtMillis() >= ANSWER_AFTER_MS
                        && answered.add(pending.decision().id())) {
                    answer(pending);
                }
            }
        }
    }

    private void answer(PendingDecision pending) {
        String plan = world.host.ask(view -> view.mission(pending.decision().mission())
                .map(MissionView::plan)
                .orElse(""));
        Answer answer = operator.answer(pending.decision(), plan).orThrow();
        world.host.post(new Input.AnswerDecision(pending.decision().id(), answer, Answerer.OPERATOR));
    }

    private List<GeoPoint> marked() {
        return effects.stream()
                .filter(effect -> effect instanceof Effect.VariableWritten written
                        && written.variable().equals("@locations"))
                .flatMap(effect -> ((ListValue) ((Effect.VariableWritten) effect).value()).items().stream())
                .map(GeoPoint.class::cast)
                .toList();
    }

    private boolean isVisited(GeoPoint location) {
        return world.boats.boatIds().stream()
                .anyMatch(boat -> Geodesy.distanceM(world.hull(boat).position(), location) < 5);
    }

    private Optional<Outcome> outcome() {
        return effects.stream()
                .filter(Effect.MissionEnded.class::isInstance)
                .map(effect -> ((Effect.MissionEnded) effect).outcome())
                .findFirst();
    }

    /** What the engine noted about the mission: these plans give it no reason to. */
    private List<Effect> problems() {
        return effects.stream()
                .filter(effect -> effect instanceof Effect.Noted noted && noted.mission() != Ids.NONE)
                .toList();
    }

    private void assertApart(int boats, double metres) {
        for (int a = 1; a <= boats; a++) {
            for (int b = 1; b < a; b++) {
                assertThat(Geodesy.distanceM(
                                world.hull("boat-" + a).position(),
                                world.hull("boat-" + b).position()))
                        .isGreaterThan(metres);
            }
        }
    }
}
