package org.sami.domain;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.spn.engine.Engine;
import org.sami.spn.model.Action;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Match;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.TokenKind;
import org.sami.spn.statespace.DeepChecks;
import org.sami.spn.statespace.DeepFinding;
import org.sami.spn.statespace.DeepRequest;
import org.sami.spn.statespace.DeepResult;
import org.sami.spn.statespace.SearchWatch;
import org.sami.spn.stepping.Stepper;

/** Panoramas by robot, asynchronous and synchronous, as authors draw them: the right ones have no finding, each wrong one has its own. */
@Tag("long")
class DeepChecksOfPanoramasTest {
    private static final int STATES = 1_500;

    private static DeepResult search(Project project, int robots) {
        DeepRequest request =
                new DeepRequest(project, TriedPlans.LIBRARY.vocabulary(), "plan", TriedPlans.robots(robots), STATES);
        return DeepChecks.ALL.get(0).run(request, SearchWatch.NONE);
    }

    private static List<DeepFinding> findings(String name, UnaryOperator<Plan> mistake) {
        Project project = TriedPlans.panorama(name);
        Project wrong = project.withPlans(List.of(mistake.apply(project.plans().get(0))));
        List<DeepFinding> findings = search(wrong, 2).findings();
        findings.forEach(found -> found.witness().ifPresent(witness -> {
            Stepper stepper = Stepper.startAs(new Engine(TriedPlans.LIBRARY.vocabulary(), wrong), "plan", witness);
            witness.steps()
                    .forEach(step -> assertThat(stepper.take(step).refusal()).isEmpty());
        }));
        return findings;
    }

    private static Plan withoutEdge(Plan plan, String place, String transition) {
        return plan.withInEdges(plan.inEdges().stream()
                .filter(edge ->
                        !edge.place().equals(place) || !edge.transition().equals(transition))
                .toList());
    }

    private static Plan requiring(Plan plan, String place, String transition, InRequirement wanted) {
        return plan.withInEdges(plan.inEdges().stream()
                .map(edge -> edge.place().equals(place) && edge.transition().equals(transition)
                        ? new InEdge(edge.id(), place, transition, edge.mode(), List.of(wanted))
                        : edge)
                .toList());
    }

    private static Plan leading(Plan plan, String transition, OutRequirement moved) {
        return plan.withOutEdges(plan.outEdges().stream()
                .map(edge -> edge.transition().equals(transition)
                        ? new OutEdge(edge.id(), transition, edge.place(), edge.mode(), List.of(moved))
                        : edge)
                .toList());
    }

    @ParameterizedTest
    @CsvSource({
        "T1-async, 1",
        "T1-async, 2",
        "T1-async, 3",
        "T5c-sync-right, 1",
        "T5c-sync-right, 2",
        "T5c-sync-right, 3"
    })
    void rightPanoramaHasNoFinding(String name, int robots) {
        DeepResult result = search(TriedPlans.panorama(name), robots);

        assertThat(result.findings())
                .extracting(found -> found.finding().message())
                .isEmpty();
    }

    @Test
    void panoramaThatBeginsWithTheFirstWhoIsThereIsFound() {
        assertThat(findings("T5a-sync-at-least-1", plan -> plan))
                .singleElement()
                .satisfies(found -> {
                    assertThat(found.finding().code()).isEqualTo("W-WAITS-FOR-NOBODY");
                    assertThat(found.finding().elements()).containsExactly("ready", "go2");
                    assertThat(found.finding().message()).contains("Nobody ever waits in place 12", "Camera");
                    assertThat(found.witness()).isPresent();
                });
    }

    @Test
    void panoramaThatWaitsForExactlyThreeIsFound() {
        InRequirement three = InRequirement.of(TokenKind.ANY_TASK, Match.EXACTLY, 3);

        assertThat(findings("T5c-sync-right", plan -> requiring(plan, "ready", "go2", three)))
                .extracting(found -> found.finding().code())
                .contains("W-STUCK");
    }

    @Test
    void endThatForgetsAPlaceIsFoundThere() {
        assertThat(findings("T1-async", plan -> withoutEdge(plan, "place-9", "allfin")))
                .filteredOn(found -> found.finding().code().equals("W-ENDS-EARLY"))
                .singleElement()
                .satisfies(found -> {
                    assertThat(found.finding().elements()).containsExactly("place-9", "allfin");
                    assertThat(found.witness()).isPresent();
                });
    }

    @Test
    void endWithTheFirstOfManyIsFoundWhereverTheOthersAre() {
        UnaryOperator<Plan> first = plan -> plan.withInEdges(plan.inEdges().stream()
                .filter(edge ->
                        !edge.transition().equals("allfin") || edge.place().equals("fin"))
                .toList());

        assertThat(findings("T1-async", first))
                .filteredOn(found -> found.finding().code().equals("W-ENDS-EARLY"))
                .extracting(found -> found.finding().elements().get(0))
                .contains("place-4", "place-6", "place-7", "place-9", "done");
    }

    @Test
    void taskThatTheEndLeavesOutIsFound() {
        OutRequirement one = new OutRequirement(TokenKind.ANY_TASK, 1, Action.TAKE, "");

        assertThat(findings("T1-async", plan -> leading(plan, "allfin", one)))
                .filteredOn(found -> found.finding().code().equals("W-LEFT-OUT"))
                .singleElement()
                .satisfies(found -> assertThat(found.finding().elements()).containsExactly("fin", "allfin"));
    }

    @Test
    void taskThatIsLeftInAPlaceWithoutAWayOnIsFound() {
        UnaryOperator<Plan> lost = plan -> withoutEdge(
                plan.withOutEdges(plan.outEdges().stream()
                                .map(edge -> edge.transition().equals("panorama-failed")
                                        ? new OutEdge(
                                                edge.id(), edge.transition(), "fin2", edge.mode(), edge.requirements())
                                        : edge)
                                .toList())
                        .withPlaces(java.util.stream.Stream.concat(
                                        plan.places().stream(),
                                        plan.place("fin").stream().map(fin -> fin.withId("fin2")))
                                .toList()),
                "fin2",
                "allfin");

        assertThat(findings("T1-async", lost))
                .filteredOn(found -> found.finding().code().equals("W-FORGOTTEN"))
                .singleElement()
                .satisfies(found -> assertThat(found.finding().elements()).containsExactly("fin2", "allfin"));
    }
}
