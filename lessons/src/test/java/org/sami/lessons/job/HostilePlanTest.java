package org.sami.lessons.job;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.spn.engine.Engine;
import org.sami.spn.json.FileTooLargeException;
import org.sami.spn.json.Reading;
import org.sami.spn.model.Action;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Match;
import org.sami.spn.model.Mode;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;

/** Plans that would run for ever, or fill the memory, are refused in a moment and in words. */
class HostilePlanTest {
    private static final Duration MOMENT = Duration.ofSeconds(20);

    private static Verdict graded(Project project) {
        return assertTimeoutPreemptively(MOMENT, () -> JobCourse.grade("gather", project));
    }

    /** Adds a ring of silent transitions behind the answer of the operator. */
    private static Project withRing(int length, OutRequirement turning, OutRequirement entering) {
        return JobCourse.with(JobCourse.solution("gather"), plan -> {
            List<Place> places = new ArrayList<>(plan.places());
            List<Transition> transitions = new ArrayList<>(plan.transitions());
            List<InEdge> ins = new ArrayList<>(plan.inEdges());
            List<OutEdge> outs = new ArrayList<>(plan.outEdges());
            for (int i = 0; i < length; i++) {
                String p = "ring" + i;
                String t = "turn" + i;
                places.add(JobGraderTest.place(p));
                transitions.add(JobGraderTest.silent(t));
                ins.add(new InEdge(
                        p + t, p, t, Mode.NOMINAL, List.of(InRequirement.of(TokenKind.GENERIC, Match.AT_LEAST, 1))));
                outs.add(new OutEdge(t + p, t, "ring" + (i + 1) % length, Mode.NOMINAL, List.of(turning)));
            }
            outs.add(new OutEdge("yes-ring", "yes", "ring0", Mode.NOMINAL, List.of(entering)));
            return plan.withPlaces(places)
                    .withTransitions(transitions)
                    .withInEdges(ins)
                    .withOutEdges(outs);
        });
    }

    @Test
    void aRingOfSilentTransitionsNeverComesToRest() {
        OutRequirement one = OutRequirement.of(Action.TAKE, 1, TokenKind.GENERIC);
        Project ring = withRing(3, one, OutRequirement.of(Action.ADD, 1, TokenKind.GENERIC));

        Verdict verdict = graded(ring);

        assertThat(verdict.passed()).isFalse();
        assertThat(run(ring).end()).isEqualTo(CaseRun.End.ENDLESS);
        assertThat(run(ring).refusal()).isEqualTo("transitions fire again and again although nothing happens");
    }

    @Test
    void tokensThatCopyThemselvesAreStopped() {
        OutRequirement copy = OutRequirement.of(Action.ADD, OutRequirement.ALL, TokenKind.GENERIC);
        Project ring = withRing(1, copy, OutRequirement.of(Action.ADD, 1, TokenKind.GENERIC));

        assertThat(graded(ring).passed()).isFalse();
        assertThat(run(ring).end()).isEqualTo(CaseRun.End.ENDLESS);
    }

    private static CaseRun run(Project project) {
        Job job = JobCourse.job("gather");
        return assertTimeoutPreemptively(
                MOMENT,
                () -> ScriptedWorld.run(
                        new Engine(JobCourse.DOMAIN.vocabulary(), project, ScriptedWorld.MOST_FIRINGS),
                        "gather",
                        job.cases().get(0),
                        () -> false));
    }

    @Test
    void anEdgeThatMakesTenThousandTokensIsNotRun() {
        Project project = JobCourse.with(
                JobCourse.solution("gather"),
                plan -> JobCourse.taking(plan, "yes.team", OutRequirement.of(Action.ADD, 10_000, TokenKind.GENERIC)));

        assertThat(graded(project).words())
                .isEqualTo("An edge of the plan speaks of more than 100 tokens: such a plan is not graded.");
    }

    @Test
    void aPlanThatRunsItselfIsNotRun() {
        Project project = JobCourse.with(
                JobCourse.solution("gather"),
                plan -> plan.withPlaces(plan.places().stream()
                        .map(place -> place.id().equals("find")
                                ? place.withSubMissions(
                                        List.of(new SubMissionSpec("again", "gather", false, Map.of(), Map.of())))
                                : place)
                        .toList()));

        assertThat(graded(project).words()).contains("or runs itself");
    }

    @Test
    void aPlanOfThousandsOfPlacesIsNotRun() {
        Project project = JobCourse.with(
                JobCourse.solution("gather"),
                plan -> plan.withPlaces(Stream.concat(
                                plan.places().stream(),
                                IntStream.range(0, 5000).mapToObj(i -> JobGraderTest.place("p" + i)))
                        .toList()));

        assertThat(graded(project).words()).contains("not graded");
    }

    @Test
    void aLoopThatAsksAgainAndAgainIsLookedAtForTenMinutesOnly() {
        Project project = JobCourse.with(JobCourse.solution("gather"), plan -> {
            Plan again = JobCourse.without(plan, "yes.find");
            List<OutEdge> outs =
                    new ArrayList<>(JobCourse.without(again, "yes.team").outEdges());
            outs.add(new OutEdge(
                    "yes.start",
                    "yes",
                    "start",
                    Mode.NOMINAL,
                    List.of(OutRequirement.of(Action.TAKE, OutRequirement.ALL, TokenKind.ANY_TOKEN))));
            return again.withOutEdges(outs);
        });

        assertThat(run(project).end()).isEqualTo(CaseRun.End.GOES_ON);
        assertThat(graded(project).passed()).isFalse();
    }

    @Test
    void aFileOfFiveMegabytesIsNotRead(@TempDir Path folder) throws IOException {
        Path file = folder.resolve("large.json");
        Files.writeString(file, "{\"name\": \"" + "x".repeat(5 << 20) + "\"}");

        assertThatThrownBy(() -> AnswerFile.read(
                        file,
                        JobCourse.LESSON,
                        JobCourse.job("gather"),
                        JobCourse.GRADER,
                        JobCourse.DOMAIN.vocabulary()))
                .isInstanceOf(FileTooLargeException.class)
                .hasMessageContaining("larger than 1 MB");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "{",
                "[]",
                "null",
                "{\"from\": 3}",
                "{\"from\": \"solution\", \"script\": [{\"do\": \"fly\"}]}",
                "\u0000",
                "{\"formatVersion\": 1}"
            })
    void whatIsNoPlanIsNamedAndNeverThrown(String text) {
        Reading<AnswerFile> read = AnswerFile.read(
                "answer.json",
                text,
                JobCourse.LESSON,
                JobCourse.job("gather"),
                JobCourse.GRADER,
                JobCourse.DOMAIN.vocabulary());

        assertThat(read.result()).isEmpty();
        assertThat(AnswerFile.errors(read)).isPresent();
    }
}
