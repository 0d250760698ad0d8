package org.sami.dreamm.tryout;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.entry;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.sami.dreamm.document.EditorState;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.spn.edit.FieldEdit;
import org.sami.spn.edit.ProjectEdit;
import org.sami.spn.edit.SetDisabled;
import org.sami.spn.edit.VertexEdit;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Mode;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.StartMarking;
import org.sami.spn.model.TestCase;
import org.sami.spn.model.TestStart;
import org.sami.spn.model.TestStep;
import org.sami.spn.testcase.CaseCoverage;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.Value;

/** Trying a plan that ships, as an author does. */
class TryOutTest {
    private static final DomainLibrary LIBRARY =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
    private static final String PLAN = "clv";
    private static final int MOST = 200;

    private final ProjectDocument document =
            new ProjectDocument(LIBRARY.vocabulary(), LIBRARY.projectOf(PLAN).orElseThrow(), Optional.empty());
    private final EditorState editor = new EditorState(document);
    private final TryOut tryOut = new TryOut(document);
    private final SavedCases cases = new SavedCases(document, editor, Runnable::run, Runnable::run);

    private Plan plan() {
        return document.plan(PLAN).orElseThrow();
    }

    private int runOn() {
        int steps = 0;
        while (steps < MOST && tryOut.stepOn()) {
            steps++;
        }
        return steps;
    }

    private void drawAnother(String place) {
        document.apply(new VertexEdit.AddPlace(
                PLAN,
                new Place(place, "", false, false, false, Mode.NOMINAL, List.of(), List.of(), List.of()),
                Optional.of(new LayoutPoint(0, 0))));
    }

    @Test
    void robotsAndOperatorThatAreNotRealBringTheMissionToItsEnd() {
        assertThat(tryOut.start(PLAN)).as(tryOut.message()).isTrue();
        assertThat(tryOut.robotNames()).hasSize(3);

        assertThat(runOn()).isPositive();

        assertThat(tryOut.isOver()).as(tryOut.message()).isTrue();
        assertThat(tryOut.lines()).extracting(TryOutLine::number).startsWith(1, 2, 3);
        assertThat(tryOut.lines().get(0).done()).startsWith("operator: robot-1, robot-2, robot-3 to ");
    }

    @Test
    void whatIsDisabledIsLeftOutAndSaysWhyItDoesNotFire() {
        String transition = plan().transitions().get(0).id();
        document.apply(new SetDisabled(PLAN, Set.of(transition), true));

        assertThat(tryOut.start(PLAN)).as(tryOut.message()).isTrue();
        assertThat(tryOut.message()).endsWith("1 disabled left out");
        runOn();

        assertThat(tryOut.isOver()).isFalse();
        assertThat(tryOut.whyNot(PLAN, transition)).contains("It is disabled for trying");
        document.undo();
        tryOut.start(PLAN);
        runOn();
        assertThat(tryOut.isOver()).as(tryOut.message()).isTrue();
    }

    @Test
    void operatorWhoDoesNotAnswerLeavesTheQuestionToTheAuthor() {
        tryOut.setMockOperator(false);
        tryOut.start(PLAN);

        assertThat(tryOut.stepOn()).isFalse();
        assertThat(tryOut.message()).contains("by hand");
        List<PossibleStep> possible = PossibleStep.of(tryOut.stepper().orElseThrow());
        assertThat(possible.get(0).who()).isEqualTo("Operator");
        assertThat(possible).extracting(PossibleStep::who).contains("Time", "Robot");
    }

    @Test
    void whatIsDoneAndWhatCanHappenIsSaidWithoutIds() {
        tryOut.start(PLAN);
        for (int i = 0; i < 8 && !tryOut.isOver(); i++) {
            assertThat(PossibleStep.of(tryOut.stepper().orElseThrow()))
                    .extracting(PossibleStep::what)
                    .noneMatch(this::speaksOfAnId);
            tryOut.stepOn();
        }

        assertThat(tryOut.lines())
                .hasSizeGreaterThan(2)
                .extracting(TryOutLine::done)
                .noneMatch(this::speaksOfAnId);
        assertThat(tryOut.lines()).extracting(TryOutLine::done).anyMatch(done -> done.contains("answering "));
    }

    /** An id that is no word as well: of an event, or the name of an event's type in one word. */
    private boolean speaksOfAnId(String words) {
        return plan().places().stream()
                        .flatMap(place -> place.outputs().stream())
                        .anyMatch(event -> words.contains(event.type())
                                || (event.id().contains("-") && words.contains(event.id())))
                || plan().transitions().stream()
                        .flatMap(transition -> transition.inputs().stream())
                        .anyMatch(event -> words.contains(event.type()));
    }

    @Test
    void runStopsWhereABreakpointIsMet() {
        String place = plan().places().get(2).id();
        Breakpoint at = new Breakpoint(PLAN, place);
        tryOut.toggle(at);
        tryOut.start(PLAN);

        int steps = 0;
        while (tryOut.met().isEmpty() && steps++ < MOST) {
            assertThat(tryOut.stepOn()).isTrue();
        }

        assertThat(tryOut.met()).contains(at);
        assertThat(tryOut.mission(PLAN).orElseThrow().marking()).containsKey(place);
        tryOut.toggle(at);
        assertThat(tryOut.met()).isEmpty();
    }

    @Test
    void stepsAreTakenBackToTheLastByte() {
        tryOut.start(PLAN);
        byte[] before = tryOut.stepper().orElseThrow().stateBytes();
        tryOut.stepOn();
        tryOut.stepOn();

        tryOut.back(2);

        assertThat(tryOut.stepper().orElseThrow().stateBytes()).isEqualTo(before);
        assertThat(tryOut.lines()).isEmpty();
        tryOut.back(1);
        assertThat(tryOut.message()).isEqualTo("This is the start");
    }

    @Test
    void planThatIsEditedMeanwhileIsSaidToBeAndRestartTakesTheStepsAgain() {
        tryOut.start(PLAN);
        tryOut.stepOn();
        document.apply(
                new VertexEdit.MoveVertices(PLAN, Map.of(plan().places().get(0).id(), new LayoutPoint(9, 9))));
        assertThat(tryOut.isOutdated()).as("a moved vertex changes no run").isFalse();

        drawAnother("another");

        assertThat(tryOut.isOutdated()).isTrue();
        assertThat(tryOut.message()).contains("has changed", "Restart");
        tryOut.restart(true);
        assertThat(tryOut.isOutdated()).isFalse();
        assertThat(tryOut.steps()).isEqualTo(1);
    }

    @Test
    void planWithAnErrorIsNotStartedAndSaysWhy() {
        document.apply(
                new VertexEdit.SetEnd(PLAN, plan().startPlace().orElseThrow().id(), true, false));

        assertThat(tryOut.start(PLAN)).isFalse();

        assertThat(tryOut.message()).startsWith("A plan with an error is not started: ");
        assertThat(tryOut.stepper()).isEmpty();
    }

    @Test
    void transitionSaysWhyItDoesNotFire() {
        tryOut.start(PLAN);

        assertThat(plan().transitions())
                .anySatisfy(t -> assertThat(tryOut.whyNot(PLAN, t.id())).isPresent());
        assertThat(tryOut.whyNot(PLAN, plan().places().get(0).id())).isEmpty();
    }

    @Test
    void keptRunPassesAsATestCaseUntilThePlanChanges() {
        tryOut.start(PLAN);
        tryOut.stepOn();
        tryOut.stepOn();
        int before = plan().testCases().size();
        document.apply(SavedCases.keeping(PLAN, tryOut.stepper().orElseThrow(), "tried"));

        assertThat(plan().testCases()).hasSize(before + 1);
        TestCase kept = plan().testCases().get(before);
        assertThat(kept.steps()).anyMatch(TestStep.ExpectTokens.class::isInstance);
        assertThat(tryOut.steps()).as("keeping takes no step").isEqualTo(2);
        assertThat(tryOut.isOutdated()).isFalse();
        cases.runAll();
        assertThat(cases.cases()).allSatisfy(result -> assertThat(result.word()).isEqualTo("passed"));
        assertThat(cases.message()).startsWith(before + 1 + " passed, 0 failed; ");

        drawAnother("another");

        assertThat(cases.cases()).allSatisfy(result -> assertThat(result.word()).isEqualTo("not run"));
    }

    @Test
    void runFromAMarkingIsKeptWithItsStart() {
        String place = plan().places().get(1).id();
        StartMarkingSetup setup = new StartMarkingSetup();
        setup.of(PLAN);
        assertThat(setup.start()).isEmpty();
        setup.put(new StartMarking.Tokens(place, 1, List.of("robot-1"), List.of()));
        TestStart start = setup.start().orElseThrow();
        assertThat(setup.marking().at(place)).hasSize(2);

        assertThat(tryOut.startAt(PLAN, start)).as(tryOut.message()).isTrue();
        document.apply(SavedCases.keeping(PLAN, tryOut.stepper().orElseThrow(), "middle"));

        TestCase kept = plan().testCases().get(plan().testCases().size() - 1);
        assertThat(kept.start()).contains(start);
        cases.runAll();
        assertThat(cases.cases())
                .allSatisfy(result -> assertThat(result.failure()).isEmpty());
        assertThat(tryOut.play(PLAN, kept)).as(tryOut.message()).isTrue();
    }

    @Test
    void markingIsStartedFromOnceWhatThePlanAsksIsGivenAndKeepsIt() {
        Project stations = LIBRARY.projectOf("station-keep").orElseThrow();
        Plan asking = stations.plan("station-keep").orElseThrow();
        ProjectDocument of = new ProjectDocument(LIBRARY.vocabulary(), stations, Optional.empty());
        TryOut tried = new TryOut(of);
        StartMarkingSetup setup = new StartMarkingSetup();
        setup.of("station-keep");
        setup.put(new StartMarking.Tokens("assemble", 1, List.of("robot-1"), List.of()));
        assertThat(AskedAtStart.of(asking, LIBRARY.vocabulary()))
                .extracting(AskedAtStart::key)
                .startsWith("ask-stations.location", "ask-stations.spacing");
        assertThat(setup.missing(asking, LIBRARY.vocabulary())).contains("ask-stations.location");
        assertThat(tried.startAt("station-keep", setup.start().orElseThrow())).isFalse();

        Value point = GeoPoint.of(45.7, 10.72);
        setup.give("ask-stations.location", point);

        assertThat(setup.missing(asking, LIBRARY.vocabulary())).isEmpty();
        TestStart start = setup.start().orElseThrow();
        assertThat(start.values()).containsExactly(entry("ask-stations.location", point));
        assertThat(tried.startAt("station-keep", start)).as(tried.message()).isTrue();
        of.apply(new FieldEdit.SetField("station-keep", "ask-stations", "location", new FieldSource.Fixed(point)));
        setup.keep(of.plan("station-keep").orElseThrow(), LIBRARY.vocabulary());
        assertThat(setup.given("ask-stations.location")).as("no longer asked").isEmpty();
    }

    @Test
    void valuesThatWereGivenAreTheFirstStepOfARunAndStandInIt() {
        ProjectDocument of = new ProjectDocument(
                LIBRARY.vocabulary(), LIBRARY.projectOf("station-keep").orElseThrow(), Optional.empty());
        TryOut tried = new TryOut(of);

        assertThat(tried.start("station-keep", Map.of("ask-stations.location", GeoPoint.of(45.7, 10.72))))
                .isTrue();

        assertThat(tried.lines()).hasSize(1);
        assertThat(tried.lines().get(0).done())
                .startsWith("operator: ")
                .contains("location = 45.7", "; spacing = ", "; duration of ")
                .endsWith("(start)");
        assertThat(tried.message()).startsWith("Started with 3 robots; ");
    }

    @Test
    void whereNotAllIsGivenTheQuestionStaysOpen() {
        ProjectDocument of = new ProjectDocument(
                LIBRARY.vocabulary(), LIBRARY.projectOf("station-keep").orElseThrow(), Optional.empty());
        TryOut tried = new TryOut(of);

        assertThat(tried.start("station-keep", Map.of("ask-stations.spacing", new RealValue(9))))
                .isTrue();

        assertThat(tried.lines()).isEmpty();
        assertThat(tried.stepper().orElseThrow().possible().decisions()).isNotEmpty();
    }

    @Test
    void coverageTellsWhatNoCaseVisits() {
        drawAnother("island");
        cases.runAll();

        CaseCoverage coverage = cases.coverage().orElseThrow();
        assertThat(coverage.neverEntered()).containsExactly("island");
        assertThat(coverage.words())
                .startsWith(
                        plan().places().size() - 1 + " of " + plan().places().size() + " places");
    }

    @Test
    void aCaseThatFailsSaysAtWhichStep() {
        TestCase wrong = new TestCase("wrong", List.of("A"), List.of(new TestStep.ExpectEnded()));
        document.apply(new ProjectEdit.SetTestCase(PLAN, "wrong", Optional.of(wrong)));
        cases.runAll();

        CaseResult failed = cases.cases().get(cases.cases().size() - 1);
        assertThat(failed.word()).isEqualTo("FAILED");
        assertThat(failed.failure()).hasValueSatisfying(why -> assertThat(why).contains("step 1", "has not ended"));
    }
}
