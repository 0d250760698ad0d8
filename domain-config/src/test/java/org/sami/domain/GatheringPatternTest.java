package org.sami.domain;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
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
import org.sami.spn.testing.PlayedTeam;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.RealValue;

/** When all are here: who comes is waited for. */
class GatheringPatternTest extends DrawnPattern {
    /** Chosen boats go to a first and a second point, and meet there; who cannot go on goes there as well. */
    private void twoLegs() {
        first("OperatorSelectBoatList");
        behind("OperatorSelectsBoatList", "AssembleLocationRequest");
        set("AssembleLocationRequest", "location", new GeoPoint(43.6, -79.4, 0));
        set("AssembleLocationRequest", "spacing", new RealValue(5));
        behind("AssembleLocationResponse", "ProxyGotoPoint");
        String second = placeBehind("ProxyPathCompleted");
        String failed = placeBehind("ProxyPathFailed");
        onto(second, "ProxyGotoPoint");
        String here = placeBehind("ProxyPathCompleted");
        lead("ProxyPathFailed", here);
        String firstFailed = plan().outEdges().stream()
                .filter(e -> e.place().equals(failed))
                .findFirst()
                .orElseThrow()
                .transition();
        done(new RemoveElements("p", Set.of(failed)));
        done(new EdgeEdit.Connect("p", firstFailed, here, Mode.NOMINAL));
        done(new EdgeEdit.SetOutRequirements(
                "p",
                plan().outEdgesOf(firstFailed).get(0).id(),
                List.of(OutRequirement.of(Action.TAKE, OutRequirement.ALL, TokenKind.RELEVANT))));
        done(new VertexEdit.NameVertex("p", here, "Here"));
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6})
    void allGoOnTogetherWhenTheLastHasComeFromEveryPlaceBefore(long seed) {
        twoLegs();
        draw("when-all-are-here", named("Here"));
        done(new VertexEdit.SetEnd("p", named("All together"), true, false));
        assertThat(findings()).isEmpty();

        PlayedTeam team = team(4, seed)
                .decides("OperatorSelectBoatList", d -> new Answer.Proxies(List.of("b1", "b2", "b3")))
                .once("AssembleLocationRequest", "AssembleLocationResponse", DrawnPattern::points)
                .each("ProxyGotoPoint", "ProxyPathCompleted");

        assertThat(team.run("p")).as("b4 was not chosen and is not waited for").contains(Outcome.ENDED);
        List<String> arrivals = plan().transitions().stream()
                .filter(t -> t.inputs().stream().anyMatch(i -> i.type().equals("ProxyPathCompleted")))
                .map(t -> t.id())
                .toList();
        assertThat(team.fired(arrivals.get(0)) + team.fired(arrivals.get(1))).isEqualTo(6);
        assertThat(team.fired(transitionNamed("All are here"))).isEqualTo(1);
    }

    @Test
    void onlyTheSelectedPlacesMustBeEmptyWhereTheAuthorSaysWhich() {
        twoLegs();
        String secondLeg = plan().places().stream()
                .filter(p -> p.outputs().stream().anyMatch(o -> o.type().equals("ProxyGotoPoint")))
                .map(Place::id)
                .reduce((a, b) -> b)
                .orElseThrow();
        draw("when-all-are-here", named("Here"), secondLeg);

        assertThat(plan().inEdgesOf(transitionNamed("All are here")))
                .extracting(e -> e.place())
                .containsExactly(named("Here"), secondLeg);
    }
}
