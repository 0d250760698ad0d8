package org.sami.domain;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.spn.edit.EdgeEdit;
import org.sami.spn.edit.RemoveElements;
import org.sami.spn.edit.VertexEdit;
import org.sami.spn.model.Action;
import org.sami.spn.model.Mode;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Place;
import org.sami.spn.model.TokenKind;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.testing.PlayedTasks;
import org.sami.spn.testing.PlayedTeam;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.wizard.AddEvent;
import org.sami.spn.wizard.EventTarget;

/** Until none is left, autonomy decides at once, ask again on no: patterns of tasks and decisions. */
class TaskPatternsTest extends DrawnPattern {
    /** Thesis, 9.1.2, with all tasks allocated at the same time: a boat that has several takes part in several rounds. */
    @ParameterizedTest
    @CsvSource({"3, 3, 1", "5, 5, 1", "5, 4, 2", "3, 1, 3"})
    void picturesAreTakenTogetherInAsManyRoundsAsABoatHasTasks(int locations, int boats, int rounds) {
        panorama();
        String taking = place("TakePanorama");
        String arrived = transition("ProxyPathCompleted");
        String here = "here";
        done(new RemoveElements("p", Set.of(plan().outEdgesOf(arrived).get(0).id())));
        done(new VertexEdit.AddPlace(
                "p",
                new Place(here, "Here", false, false, false, Mode.NOMINAL, List.of(), List.of(), List.of()),
                Optional.empty()));
        done(new EdgeEdit.Connect("p", arrived, here, Mode.NOMINAL));
        done(new EdgeEdit.SetOutRequirements(
                "p",
                plan().outEdgesOf(arrived).get(0).id(),
                List.of(OutRequirement.of(Action.TAKE, OutRequirement.ALL, TokenKind.RELEVANT))));
        draw("when-all-are-here", here);
        String together = transitionNamed("All are here");
        done(new RemoveElements("p", Set.of(named("All together"))));
        done(new EdgeEdit.Connect("p", together, taking, Mode.NOMINAL));
        done(new EdgeEdit.SetOutRequirements(
                "p",
                plan().outEdgesOf(together).get(0).id(),
                List.of(OutRequirement.of(Action.TAKE, OutRequirement.ALL, TokenKind.ANY_TASK))));
        draw("autonomy-decides-at-once", place("OperatorAllocationOptions"));
        draw("ask-again-on-no", place("OperatorAllocationOptions"));
        draw("until-none-is-left", named("Finished"));

        PlayedTeam team = camera(locations, boats, 1);

        assertThat(team.run("p")).contains(Outcome.ENDED);
        assertThat(team.fired(together)).isBetween((long) rounds, (long) locations);
        assertThat(team.fired(transition("TaskCompleted"))).isEqualTo(locations);
    }

    /** The asynchronous panorama plan of the thesis, 9.1.2, as its additions draw it. */
    private void panorama() {
        first("OperatorCreateLocations");
        behind("OperatorCreatesLocations", "GenerateTasks");
        set("GenerateTasks", "taskClass", new TextValue("Camera"));
        behind("TasksGenerated", "AllocationRequest");
        behind("AllocationResponse", "OperatorAllocationOptions");
        behind("OperatorAcceptedAllocation", "ApplyAllocation");
        done(AddEvent.usual(
                "p",
                "TaskStarted",
                new EventTarget.Behind(placeBehind("OperatorAcceptedAllocation")),
                Mode.NOMINAL,
                LIBRARY));
        behind("TaskStarted", "ProxyGotoLatLon");
        behind("ProxyPathCompleted", "TakePanorama");
        behind("PanoramaTaken", "StartProxyTimer");
        set("StartProxyTimer", "duration", new DurationValue(5000));
        behind("ProxyTimerExpired", "TaskComplete");
        done(new VertexEdit.NameVertex("p", placeBehind("TaskCompleted"), "Finished"));
        lead("ProxyPathFailed", place("TaskComplete"));
        lead("PanoramaFailed", place("TaskComplete"));
    }

    private PlayedTeam camera(int locations, int boats, long seed) {
        return team(boats, seed)
                .decides(
                        "OperatorCreateLocations",
                        d -> new Answer.Fields(Map.of("locations", PlayedTasks.locations(locations))))
                .once(
                        "AllocationRequest",
                        "AllocationResponse",
                        a -> Map.of("allocations", PlayedTasks.allocations(a, boats)))
                .works("TaskStarted", "TaskComplete")
                .each("ProxyGotoLatLon", "ProxyPathCompleted")
                .each("TakePanorama", "PanoramaTaken")
                .each("TaskComplete", "TaskCompleted");
    }

    @ParameterizedTest
    @CsvSource({"1, 1", "3, 3", "5, 2", "5, 5", "3, 1"})
    void missionEndsWhenNoTaskIsLeftAnywhere(int locations, int boats) {
        panorama();
        draw("autonomy-decides-at-once", place("OperatorAllocationOptions"));
        draw("ask-again-on-no", place("OperatorAllocationOptions"));
        draw("until-none-is-left", named("Finished"));
        assertThat(findings()).isEmpty();

        for (long seed = 1; seed <= 5; seed++) {
            PlayedTeam team = camera(locations, boats, seed);
            assertThat(team.run("p")).as("seed %d", seed).contains(Outcome.ENDED);
            assertThat(team.fired(transition("TaskCompleted"))).isEqualTo(locations);
            assertThat(team.fired(transitionNamed("None is left"))).isEqualTo(1);
        }
    }

    @Test
    void severalPlacesOfThoseWhoAreDoneEndThePlanTogether() {
        panorama();
        done(new RemoveElements(
                "p",
                Set.of(plan().outEdgesOf(transition("PanoramaFailed")).get(0).id())));
        done(new VertexEdit.AddPlace(
                "p",
                new Place("lost", "Lost", false, false, false, Mode.NOMINAL, List.of(), List.of(), List.of()),
                Optional.empty()));
        done(new EdgeEdit.Connect("p", transition("PanoramaFailed"), "lost", Mode.NOMINAL));
        done(new EdgeEdit.SetOutRequirements(
                "p",
                plan().outEdgesOf(transition("PanoramaFailed")).get(0).id(),
                List.of(OutRequirement.of(Action.TAKE, OutRequirement.ALL, TokenKind.RELEVANT))));
        draw("autonomy-decides-at-once", place("OperatorAllocationOptions"));
        draw("ask-again-on-no", place("OperatorAllocationOptions"));

        draw("until-none-is-left", named("Finished"), "lost");

        assertThat(findings()).isEmpty();
        assertThat(plan().places().stream().filter(Place::end)).hasSize(1);
        assertThat(camera(3, 3, 1).each("TakePanorama", "PanoramaFailed").run("p"))
                .contains(Outcome.ENDED);
        assertThat(camera(3, 3, 1).run("p")).contains(Outcome.ENDED);
    }

    @Test
    void autonomyAnswersWithoutTheOperator() {
        panorama();
        draw("autonomy-decides-at-once", place("OperatorAllocationOptions"));

        PlayedTeam team = camera(2, 2, 1).decides("OperatorAllocationOptions", d -> {
            throw new AssertionError("the operator was asked");
        });

        team.run("p");
        assertThat(team.fired(transition("OperatorAcceptedAllocation"))).isEqualTo(1);
    }

    @Test
    void rejectedOptionsAreRequestedAnew() {
        panorama();
        draw("ask-again-on-no", place("OperatorAllocationOptions"));
        draw("until-none-is-left", named("Finished"));
        assertThat(findings()).isEmpty();
        int[] asked = {0};

        PlayedTeam team = camera(3, 3, 1)
                .decides(
                        "OperatorAllocationOptions",
                        d -> asked[0]++ < 2 ? new Answer.Rejected() : new Answer.Option(0));

        assertThat(team.run("p")).contains(Outcome.ENDED);
        assertThat(team.asked().stream().filter(a -> a.type().equals("AllocationRequest")))
                .hasSize(3);
    }

    @Test
    void noLeadsBackToAQuestionOfYesOrNo() {
        first("OperatorApprove");
        draw("ask-again-on-no", place("OperatorApprove"));
        done(new VertexEdit.SetEnd("p", placeBehind("YesOption"), true, false));
        assertThat(findings()).isEmpty();
        int[] asked = {0};

        PlayedTeam team = team(1, 1).decides("OperatorApprove", d -> new Answer.YesNo(asked[0]++ >= 2));

        assertThat(team.run("p")).contains(Outcome.ENDED);
        assertThat(asked[0]).isEqualTo(3);
    }
}
