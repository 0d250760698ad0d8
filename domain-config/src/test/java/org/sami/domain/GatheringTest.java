package org.sami.domain;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.spn.analysis.PlanChecks;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.EditHistory;
import org.sami.spn.edit.EditResult;
import org.sami.spn.edit.FieldEdit;
import org.sami.spn.edit.PlanBuilder;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Mode;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.WaitFor;
import org.sami.spn.pattern.PatternSpot;
import org.sami.spn.pattern.Patterns;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.sequence.AuthoringLibrary;
import org.sami.spn.sequence.Gathering;
import org.sami.spn.sequence.Sequence;
import org.sami.spn.testing.PlayedTeam;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.Value;
import org.sami.spn.wizard.AddEvent;
import org.sami.spn.wizard.ChangeWaiting;
import org.sami.spn.wizard.EventTarget;

/** The three ways in which a plan goes on where boats answer one by one: drawn without an error, and run as their names say. */
class GatheringTest {
    private static final DomainLibrary BOATS =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
    private static final AuthoringLibrary LIBRARY = BOATS.authoring();

    private final EditHistory history = new EditHistory(
            new Project("project", "", "crw", List.of(), List.of(), List.of(new PlanBuilder("p").build())),
            BOATS.vocabulary(),
            100);

    private Plan plan() {
        return history.project().plans().get(0);
    }

    private void done(Edit edit) {
        assertThat(history.apply(edit)).isInstanceOf(EditResult.Done.class);
    }

    private String placeBehind(String answer) {
        return plan().outEdgesOf(transition(answer)).get(0).place();
    }

    private String transition(String answer) {
        return plan().transitions().stream()
                .filter(t -> t.inputs().stream().anyMatch(i -> i.type().equals(answer)))
                .findFirst()
                .orElseThrow()
                .id();
    }

    /** Boats are chosen, get a location each, go there, and then the operator is told. */
    private void draw(Gathering gathering) {
        done(AddEvent.usual(
                "p",
                "OperatorSelectBoatList",
                new EventTarget.Free(Optional.of(new LayoutPoint(60, 200))),
                Mode.NOMINAL,
                LIBRARY));
        add("OperatorSelectsBoatList", "AssembleLocationRequest", Gathering.WAIT_FOR_ALL);
        String request = plan().places().stream()
                .flatMap(p -> p.outputs().stream())
                .filter(o -> o.type().equals("AssembleLocationRequest"))
                .findFirst()
                .orElseThrow()
                .id();
        done(new FieldEdit.SetField("p", request, "spacing", new FieldSource.Fixed(new RealValue(5))));
        done(new FieldEdit.SetField("p", request, "location", new FieldSource.Fixed(new GeoPoint(43.6, -79.4, 0))));
        String go = placeBehind("AssembleLocationResponse");
        String sequence = LIBRARY.of("ProxyGotoPoint").stream()
                .filter(s -> s.name().equals(gathering.label()))
                .findFirst()
                .orElseThrow()
                .id();
        done(AddEvent.usual("p", "ProxyGotoPoint", new EventTarget.OnVertex(go), Mode.NOMINAL, LIBRARY)
                .withSequence(sequence));
        Set<String> ends = new LinkedHashSet<>();
        plan().places().stream()
                .map(Place::id)
                .filter(p -> plan().inEdges().stream().noneMatch(e -> e.place().equals(p)))
                .forEach(ends::add);
        PatternSpot spot = new PatternSpot(history.project(), plan(), ends, Mode.NOMINAL, BOATS.vocabulary(), LIBRARY);
        done(Patterns.of(LIBRARY).stream()
                .filter(p -> p.id().equals("until-none-is-left"))
                .findFirst()
                .orElseThrow()
                .edit(spot));
    }

    private void add(String answer, String event, Gathering gathering) {
        done(AddEvent.usual("p", event, new EventTarget.OnVertex(placeBehind(answer)), Mode.NOMINAL, LIBRARY)
                .withSequence(
                        LIBRARY.of(event).stream().anyMatch(s -> s.id().equals(gathering.id()))
                                ? gathering.id()
                                : Sequence.USUAL));
    }

    private PlayedTeam team(int boats, long seed) {
        return new PlayedTeam(history.project(), BOATS.vocabulary(), boats, seed)
                .once("AssembleLocationRequest", "AssembleLocationResponse", a -> {
                    Map<Value, Value> points = new LinkedHashMap<>();
                    a.proxies().forEach(p -> points.put(new ProxyValue(p), new GeoPoint(43.6, -79.4, 0)));
                    return Map.of("points", new MapValue(points));
                })
                .each("ProxyGotoPoint", "ProxyPathCompleted");
    }

    @Test
    void everyEventWhoseAnswersComeOneByOneOffersTheThreeWays() {
        for (String event : List.of(
                "ProxyGotoLatLon",
                "ProxyExecutePath",
                "ProxyGotoPoint",
                "TakePanorama",
                "TakeMeasurement",
                "ProxyExploreArea",
                "ProxyPathCompleted",
                "PanoramaTaken")) {
            assertThat(LIBRARY.of(event))
                    .as(event)
                    .extracting(Sequence::name)
                    .containsExactlyInAnyOrder(
                            "Waits for all", "Each goes on as it arrives", "Each as it arrives, then all together");
        }
        assertThat(LIBRARY.of("StartProxyTimer")).extracting(Sequence::name).containsExactly("With its usual answers");
    }

    @ParameterizedTest
    @EnumSource(Gathering.class)
    void planThatIsDrawnSoPassesAllChecks(Gathering gathering) {
        draw(gathering);

        assertThat(PlanChecks.check(history.project(), BOATS.vocabulary())).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5})
    void allWaitForTheLastAndGoOnInOneFiring(long seed) {
        draw(Gathering.WAIT_FOR_ALL);

        PlayedTeam team = team(3, seed);

        assertThat(team.run("p")).contains(Outcome.ENDED);
        assertThat(team.fired(transition("ProxyPathCompleted"))).isEqualTo(1);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5})
    void eachLeavesAndAllGoOnWhenNobodyIsUnderWay(long seed) {
        draw(Gathering.EACH_THEN_TOGETHER);
        String together = plan().transitions().stream()
                .filter(t -> t.name().equals("Nobody is under way"))
                .findFirst()
                .orElseThrow()
                .id();

        PlayedTeam team = team(3, seed);

        assertThat(team.run("p")).contains(Outcome.ENDED);
        String arrived = transition("ProxyPathCompleted");
        assertThat(team.firedOf(arrived, together)).containsExactly(arrived, arrived, arrived, together);
    }

    @Test
    void eachGoesOnAloneAndTheGenericTokenIsLeftToTheOthers() {
        draw(Gathering.EACH);
        Plan each = plan();
        String arrived = transition("ProxyPathCompleted");

        assertThat(each.inEdgesOf(arrived).get(0).requirements()).hasSize(1);
        PlayedTeam team = team(3, 1);
        assertThat(team.run("p")).contains(Outcome.ENDED);
        assertThat(team.fired(arrived)).isEqualTo(3);

        done(new ChangeWaiting("p", arrived, WaitFor.ALL, LIBRARY));
        assertThat(plan().inEdgesOf(arrived).get(0).requirements()).hasSize(2);
        done(new ChangeWaiting("p", arrived, WaitFor.EACH, LIBRARY));
        assertThat(plan().inEdgesOf(arrived).get(0).requirements()).hasSize(1);
    }
}
