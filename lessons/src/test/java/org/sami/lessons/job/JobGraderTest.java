package org.sami.lessons.job;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CancellationException;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.lessons.course.LessonJson;
import org.sami.spn.model.Action;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Match;
import org.sami.spn.model.Mode;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.TestCase;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;
import org.sami.spn.model.WaitFor;
import org.sami.spn.testcase.TestCaseRunner;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.TextValue;

class JobGraderTest {
    private static final InRequirement NO_ROBOT = InRequirement.of(TokenKind.ANY_PROXY, Match.ZERO, 0);
    private static final OutRequirement TAKE_RELEVANT =
            OutRequirement.of(Action.TAKE, OutRequirement.ALL, TokenKind.RELEVANT);

    @ParameterizedTest
    @ValueSource(strings = {"gather", "visit"})
    void theSolutionPasses(String job) {
        Verdict verdict = JobCourse.grade(job, JobCourse.solution(job));

        assertThat(verdict.words()).startsWith("That is right");
        assertThat(verdict.passed()).isTrue();
    }

    @ParameterizedTest
    @ValueSource(strings = {"gather", "visit"})
    void otherNamesIdsVariablesAndAnotherOrderDoNotMatter(String job) {
        Verdict verdict = JobCourse.grade(job, OtherIds.of(JobCourse.solution(job)));

        assertThat(verdict.passed()).as(verdict.words()).isTrue();
    }

    @Test
    void anotherButRightRequirementIsAccepted() {
        InRequirement lessThanOne = InRequirement.of(TokenKind.ANY_PROXY, Match.LESS_THAN, 1);

        Verdict verdict = JobCourse.grade(
                "gather",
                JobCourse.with(
                        JobCourse.solution("gather"),
                        plan -> JobCourse.requiring(
                                JobCourse.requiring(plan, "go.all", lessThanOne), "find.all", lessThanOne)));

        assertThat(verdict.passed()).as(verdict.words()).isTrue();
    }

    /** Failed robots go to a place of their own, over one transition more. */
    @Test
    void anotherButRightNetIsAccepted() {
        Verdict verdict = JobCourse.grade("gather", JobCourse.with(JobCourse.solution("gather"), plan -> {
            List<Place> places = new ArrayList<>(plan.places());
            places.add(place("lost"));
            places.add(place("beach"));
            List<Transition> transitions = new ArrayList<>(plan.transitions());
            transitions.add(silent("home"));
            List<InEdge> ins = new ArrayList<>(plan.inEdges());
            ins.add(new InEdge(
                    "lost.home",
                    "lost",
                    "home",
                    Mode.NOMINAL,
                    List.of(InRequirement.of(TokenKind.ANY_PROXY, Match.AT_LEAST, 1))));
            List<OutEdge> outs =
                    new ArrayList<>(JobCourse.without(plan, "failed.there").outEdges());
            outs.add(new OutEdge("failed.lost", "failed", "lost", Mode.NOMINAL, List.of(TAKE_RELEVANT)));
            outs.add(new OutEdge(
                    "home.beach",
                    "home",
                    "beach",
                    Mode.NOMINAL,
                    List.of(OutRequirement.of(Action.TAKE, OutRequirement.ALL, TokenKind.ANY_PROXY))));
            return plan.withPlaces(places)
                    .withTransitions(transitions)
                    .withInEdges(ins)
                    .withOutEdges(outs);
        }));

        assertThat(verdict.passed()).as(verdict.words()).isTrue();
    }

    @Test
    void whereAPointIsDrawnAndWhatOperatorsReadIsEverybodysOwnChoice() {
        Verdict verdict = JobCourse.grade(
                "gather",
                JobCourse.with(
                        JobCourse.solution("gather"),
                        plan -> plan.withPlaces(plan.places().stream()
                                .map(one -> one.withOutputs(one.outputs().stream()
                                        .map(output -> switch (output.type()) {
                                            case "OperatorApprove" ->
                                                output.withFields(Map.of(
                                                        "question", new FieldSource.Fixed(new TextValue("Go?"))));
                                            case "AssembleLocationRequest" ->
                                                output.withFields(Map.of(
                                                        "location",
                                                        new FieldSource.Fixed(GeoPoint.of(45, 10)),
                                                        "spacing",
                                                        output.fields().get("spacing")));
                                            default -> output;
                                        })
                                        .toList()))
                                .toList())));

        assertThat(verdict.passed()).as(verdict.words()).isTrue();
    }

    @Test
    void theKnownMistakeIsSaidWithTheStepThatExplainsItAndARunThatCanBePlayed() {
        Project wrong = JobCourse.with(
                JobCourse.solution("gather"),
                plan -> JobCourse.requiring(
                        JobCourse.without(
                                plan.withInEdges(Stream.concat(
                                                plan.inEdges().stream(),
                                                Stream.of(new InEdge(
                                                        "there.all",
                                                        "there",
                                                        "all",
                                                        Mode.NOMINAL,
                                                        List.of(InRequirement.of(
                                                                TokenKind.ANY_PROXY, Match.AT_LEAST, 1)))))
                                        .toList()),
                                "go.all"),
                        "find.all",
                        NO_ROBOT));

        Verdict verdict = JobCourse.grade("gather", wrong);

        assertThat(verdict.words()).isEqualTo("The mission ends with the first robot that arrives.");
        assertThat(verdict.stage()).isEqualTo(Verdict.Stage.CASES);
        assertThat(verdict.explained()).contains("01-jobs/all");
        assertThat(verdict.failedCase()).contains("three robots");
        TestCase run = verdict.run().orElseThrow();
        Plan played = wrong.plans().get(0).withTestCases(List.of(run));
        assertThat(new TestCaseRunner(wrong.withPlans(List.of(played)), JobCourse.DOMAIN.vocabulary()).run(played, run))
                .isEmpty();
        assertThat(verdict.steps()).hasSameSizeAs(run.steps()).anyMatch(line -> line.contains("Proxy Path Completed"));
    }

    @Test
    void aMistakeThatNothingNamesIsSaidByTheFirstDifference() {
        Project wrong = JobCourse.with(JobCourse.solution("gather"), plan -> {
            Plan deaf = JobCourse.without(JobCourse.without(plan, "go.failed"), "failed.there");
            return deaf.withTransitions(deaf.transitions().stream()
                    .filter(one -> !one.id().equals("failed"))
                    .toList());
        });

        Verdict verdict = JobCourse.grade("gather", wrong);

        assertThat(verdict.words())
                .isEqualTo(
                        "With 3 robots (the second fails), Display Message does not happen at 11 s; with a right plan it does.");
        assertThat(verdict.failedCase()).contains("the second fails");
    }

    @Test
    void theFirstDifferenceNamesWhoDoesWhatTooEarly() {
        Verdict verdict = JobCourse.grade(
                "visit",
                JobCourse.with(
                        JobCourse.solution("visit"),
                        plan -> JobCourse.taking(
                                plan,
                                "started.go",
                                OutRequirement.of(Action.TAKE, OutRequirement.ALL, TokenKind.ANY_TASK))));

        assertThat(verdict.words())
                .isEqualTo(
                        "With 2 robots, Proxy Goto Lat Lon for task 3 (anna) happens already at 2 s, with a right plan only at 4 s.");
    }

    @ParameterizedTest
    @ValueSource(strings = {"gather", "visit"})
    void theStartIsRefusedWithTheMistakeThatFits(String job) {
        Verdict verdict = JobCourse.grade(job, JobCourse.start(job));

        assertThat(verdict.passed()).isFalse();
        assertThat(verdict.words())
                .isIn("Nothing ends the mission when all are there.", "The mission ends with the first finished task.");
    }

    @Test
    void errorsOfTheChecksAreSaidBeforeAnythingRuns() {
        Verdict verdict = JobCourse.grade(
                "gather",
                JobCourse.with(JobCourse.solution("gather"), plan -> JobCourse.requiring(plan, "go.arrived")));

        assertThat(verdict.stage()).isEqualTo(Verdict.Stage.CHECKS);
        assertThat(verdict.words()).contains("has no requirement");
        assertThat(verdict.elements()).containsExactly("go.arrived");
    }

    @Test
    void whatTheJobAsksToBeUsedIsSaidInItsWords() {
        Verdict verdict = JobCourse.grade(
                "gather",
                JobCourse.with(
                        JobCourse.solution("gather"),
                        plan -> plan.withTransitions(plan.transitions().stream()
                                .map(one -> one.withInputs(one.inputs().stream()
                                        .map(input -> input.withWrites(Map.of()))
                                        .toList()))
                                .toList())));

        assertThat(verdict.words()).isEqualTo("Proxy Goto Point does not read what the service writes.");
    }

    @Test
    void aFileWithoutThePlanOfTheJobIsRefused() {
        assertThat(JobCourse.grade("gather", JobCourse.solution("visit")).words())
                .isEqualTo("The file has no plan \"gather\": that is the plan of this job.");
    }

    @Test
    void gradingCanBeCancelled() {
        Job job = JobCourse.job("gather");
        Project project = JobCourse.solution("gather");

        assertThatThrownBy(() -> JobCourse.GRADER.grade(JobCourse.LESSON, job, project, () -> true))
                .isInstanceOf(CancellationException.class);
    }

    @Test
    void theVerdictIsWrittenAsJson() {
        assertThat(LessonJson.write(JobCourse.grade("gather", JobCourse.start("gather"))))
                .contains("\"passed\" : false", "\"stage\" : \"CASES\"", "\"explained\" : \"01-jobs/all\"", "\"steps\"")
                .doesNotContain("\"run\"");
    }

    static Place place(String id) {
        return new Place(id, id, false, false, false, Mode.NOMINAL, List.of(), List.of(), List.of());
    }

    static Transition silent(String id) {
        return new Transition(id, id, Mode.NOMINAL, WaitFor.EACH, List.of());
    }
}
