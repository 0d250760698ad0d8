package org.sami.lessons.job;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.spn.edit.PlanBuilder;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;

class SolutionBesideTest {
    private static Plan solution() {
        return new PlanBuilder("p")
                .start("start")
                .transition("go")
                .output("wait", "StartSystemTimer")
                .transition("passed", "TimerExpired")
                .end("end")
                .in("start", "go")
                .out("go", "wait")
                .in("wait", "passed")
                .out("passed", "end")
                .build();
    }

    @Test
    void thePlanOfAnotherAuthorIsTheSameWithItsIds() {
        Plan solution = solution();
        Plan mine = OtherIds.of(new Project("x", "", "crw", List.of(), List.of(), List.of(solution)))
                .plan("p")
                .orElseThrow();

        Plan beside = SolutionBeside.of(solution, mine);

        assertThat(beside.elementIds()).containsExactlyInAnyOrderElementsOf(mine.elementIds());
        assertThat(beside.places())
                .usingRecursiveFieldByFieldElementComparatorIgnoringFields("transitionOrder") // OtherIds writes it out
                .containsExactlyInAnyOrderElementsOf(mine.places());
    }

    @Test
    void whatTheLearnerLacksKeepsItsIdsAndNothingStandsForTwo() {
        Plan mine = new PlanBuilder("p")
                .start("start")
                .transition("go")
                .places("end")
                .in("start", "go")
                .out("go", "end")
                .build();

        Plan beside = SolutionBeside.of(solution(), mine);

        assertThat(beside.place("wait")).isPresent();
        assertThat(beside.transition("passed")).isPresent();
        assertThat(beside.elementIds()).hasSameSizeAs(solution().elementIds());
        assertThat(beside.inEdges())
                .allSatisfy(edge -> assertThat(beside.place(edge.place())).isPresent());
    }

    @Test
    void aLearnersIdThatMeansSomethingElseIsNotTakenTwice() {
        Plan mine = new PlanBuilder("p")
                .start("start")
                .transition("go", "TimerExpired")
                .in("start", "go")
                .transition("wait")
                .build();

        Plan beside = SolutionBeside.of(solution(), mine);

        assertThat(beside.place("wait")).isEmpty();
        assertThat(beside.place("wait-solution")).isPresent();
    }
}
