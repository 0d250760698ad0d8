package org.sami.domain;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.spn.drawing.RequirementWords;
import org.sami.spn.edit.PlanBuilder;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.Action;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Match;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.TokenKind;
import org.sami.spn.wizard.SoundRequirements;

/** What is proposed for an edge is sound there: it can be met, and it speaks of tokens that somebody names. */
class SoundRequirementsTest {
    private static final DomainLibrary BOATS =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();

    private static PlanBuilder tasks() {
        return new PlanBuilder("p")
                .start("begin")
                .output("begin", "GenerateTasks")
                .places("work", "done", "all-done")
                .end("all-done")
                .output("work", "ProxyGotoLatLon")
                .transition("made", "TasksGenerated")
                .transition("arrived", "ProxyPathCompleted")
                .transition("finished")
                .in("begin", "made", InRequirement.of(TokenKind.GENERIC, Match.AT_LEAST, 1))
                .out("made", "work", OutRequirement.of(Action.ADD, OutRequirement.ALL, TokenKind.RELEVANT));
    }

    private static SoundRequirements of(Plan plan) {
        return new SoundRequirements(
                new Project("project", "", "crw", List.of(), List.of(), List.of(plan)),
                plan,
                BOATS.vocabulary(),
                BOATS.authoring());
    }

    private static List<String> in(Plan plan, int edge) {
        return of(plan).in(plan.inEdges().get(edge)).stream()
                .map(RequirementWords::of)
                .toList();
    }

    private static List<String> out(Plan plan, int edge) {
        return of(plan).out(plan.outEdges().get(edge)).stream()
                .map(RequirementWords::of)
                .toList();
    }

    @Test
    void relevantIsProposedWhereAnAnswerNamesSomebody() {
        Plan plan = tasks().in("work", "arrived").out("arrived", "done").build();

        assertThat(in(plan, 1)).startsWith("All Relevant");
        assertThat(out(plan, 1)).startsWith("Take All Relevant");
        assertThat(of(plan).namesTokens("arrived")).isTrue();
    }

    @Test
    void relevantIsNotProposedWhereNoInputEventNamesAnybody() {
        Plan plan = tasks().in("work", "arrived")
                .out("arrived", "done", OutRequirement.of(Action.TAKE, OutRequirement.ALL, TokenKind.RELEVANT))
                .in("done", "finished")
                .out("finished", "all-done")
                .build();

        assertThat(in(plan, 2)).contains("≥ 1 Task").noneMatch(w -> w.contains("Relevant"));
        assertThat(out(plan, 2)).contains("Take All Task").noneMatch(w -> w.contains("Relevant"));
        assertThat(of(plan).namesTokens("finished")).isFalse();
    }

    @Test
    void secondEdgeIsOfferedThatNobodyIsLeftThere() {
        Plan plan = tasks().in("work", "arrived", InRequirement.allRelevant())
                .out("arrived", "done", OutRequirement.of(Action.TAKE, OutRequirement.ALL, TokenKind.RELEVANT))
                .in("done", "finished", InRequirement.of(TokenKind.ANY_TASK, Match.AT_LEAST, 1))
                .in("work", "finished")
                .out("finished", "all-done")
                .build();

        assertThat(in(plan, 3)).startsWith("No Task").contains("No Proxy");
        assertThat(in(plan, 2)).as("somebody must be somewhere").doesNotContain("No Task");
    }

    @Test
    void firstEdgeOfATransitionIsNotOfferedThatNobodyIsThere() {
        Plan plan = tasks().in("work", "arrived").out("arrived", "done").build();

        assertThat(in(plan, 1)).doesNotContain("No Proxy", "No Task");
    }

    @Test
    void whatStandsThereIsNotProposedAgain() {
        Plan plan = tasks().in("work", "arrived", InRequirement.allRelevant())
                .out("arrived", "done", OutRequirement.of(Action.TAKE, OutRequirement.ALL, TokenKind.RELEVANT))
                .build();

        assertThat(in(plan, 1)).doesNotContain("All Relevant");
        assertThat(out(plan, 1)).doesNotContain("Take All Relevant");
    }
}
