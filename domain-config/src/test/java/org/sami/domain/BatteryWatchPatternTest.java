package org.sami.domain;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.spn.edit.VertexEdit;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.Mode;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.sequence.Gathering;
import org.sami.spn.testing.PlayedTeam;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.RealValue;
import org.sami.spn.wizard.AddEvent;
import org.sami.spn.wizard.EventTarget;

/** Battery watch around this: a boat with a low battery leaves and comes back. */
class BatteryWatchPatternTest extends DrawnPattern {
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void boatWithALowBatteryWaitsForItsChangeAndIsWaitedFor(long seed) {
        history = history(BOATS.projectOf("explore-area").orElseThrow());
        List<Finding> before = findings();
        draw("battery-watch-around-this", "explore");
        assertThat(findings()).isEqualTo(before);
        Set<String> low = new HashSet<>();

        PlayedTeam team = team(3, seed)
                .decides(
                        "OperatorCreateArea",
                        d -> new Answer.Fields(Map.of(
                                "area",
                                new GeoArea(
                                        List.of(
                                                new GeoPoint(43.6, -79.4, 0),
                                                new GeoPoint(43.61, -79.4, 0),
                                                new GeoPoint(43.6, -79.41, 0)),
                                        List.of()))))
                .some(
                        "BatteryLevelSubscription",
                        "BatteryLow",
                        a -> a.proxies().contains("b2") && low.add("b2") ? List.of("b2") : List.of())
                .some(
                        "ProxyExploreArea",
                        "ProxyPathCompleted",
                        a -> a.proxies().stream()
                                .filter(p -> !p.equals("b2")
                                        || (low.contains("b2") && a.proxies().size() == 1))
                                .toList());

        assertThat(team.run("explore-area")).contains(Outcome.ENDED);
        assertThat(team.fired("explored")).isEqualTo(3);
        assertThat(team.fired(transitionNamed("Battery changed"))).isEqualTo(1);
    }

    /** Chosen boats go to a point and end there: all together, as the transition waits for all. */
    private void goTogether() {
        first("OperatorSelectBoatList");
        behind("OperatorSelectsBoatList", "AssembleLocationRequest");
        set("AssembleLocationRequest", "location", new GeoPoint(43.6, -79.4, 0));
        set("AssembleLocationRequest", "spacing", new RealValue(5));
        done(AddEvent.usual(
                        "p",
                        "ProxyGotoPoint",
                        new EventTarget.OnVertex(placeBehind("AssembleLocationResponse")),
                        Mode.NOMINAL,
                        LIBRARY)
                .withSequence(Gathering.WAIT_FOR_ALL.id()));
        done(new VertexEdit.SetEnd("p", placeBehind("ProxyPathCompleted"), true, false));
    }

    /** A team of three, of whom b2's battery is low once; it arrives only after that. */
    private PlayedTeam teamWithALowBattery(long seed) {
        Set<String> low = new HashSet<>();
        return team(3, seed)
                .decides("OperatorSelectBoatList", d -> new Answer.Proxies(List.of("b1", "b2", "b3")))
                .once("AssembleLocationRequest", "AssembleLocationResponse", DrawnPattern::points)
                .some(
                        "BatteryLevelSubscription",
                        "BatteryLow",
                        a -> a.proxies().contains("b2") && low.add("b2") ? List.of("b2") : List.of())
                .some(
                        "ProxyGotoPoint",
                        "ProxyPathCompleted",
                        a -> a.proxies().stream()
                                .filter(p -> !p.equals("b2") || a.proxies().size() == 1)
                                .toList());
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6})
    void whoWaitsForAllWaitsForABoatWhoseBatteryIsChanged(long seed) {
        goTogether();
        draw("battery-watch-around-this", place("ProxyGotoPoint"));

        PlayedTeam team = teamWithALowBattery(seed);

        assertThat(team.run("p")).contains(Outcome.ENDED);
        assertThat(team.firedOf(transitionNamed("Battery changed"), transition("ProxyPathCompleted")))
                .as("b2 comes back before the others go on")
                .containsExactly(transitionNamed("Battery changed"), transition("ProxyPathCompleted"));
    }

    @Test
    void whoeverTakesAllAlongTakesABoatWhoseBatteryIsChanged() {
        history = history(BOATS.projectOf("station-keep").orElseThrow());
        draw("battery-watch-around-this", "hold");
        String away = named("Change the battery");

        assertThat(plan().inEdges().stream().filter(e -> e.place().equals(away)).map(e -> e.transition()))
                .contains("finish", "stop")
                .doesNotContain("time-to-look");
    }

    @Test
    void watchSaysWhereItCannotStand() {
        history = history(BOATS.projectOf("explore-area").orElseThrow());

        assertThat(pattern("battery-watch-around-this").refusal(spot("end"))).contains("The mission ends in \"End\"");
        assertThat(pattern("battery-watch-around-this").refusal(spot("explore", "wait")))
                .contains("Select one place where robots work");
        draw("battery-watch-around-this", "explore");
        assertThat(pattern("battery-watch-around-this").refusal(spot("explore")))
                .contains("\"Explore\" is watched already");
    }
}
