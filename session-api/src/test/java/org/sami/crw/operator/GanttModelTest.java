package org.sami.crw.operator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.groups.Tuple.tuple;

import java.util.List;
import java.util.Map;
import java.util.OptionalLong;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.sami.crw.operator.gantt.GanttBar;
import org.sami.crw.operator.gantt.GanttMission;
import org.sami.crw.operator.gantt.GanttPhase;
import org.sami.crw.operator.gantt.GanttRow;
import org.sami.spn.engine.EngineView;
import org.sami.spn.phase.PhaseProgress.Status;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Input;

/** A mission of two phases: a boat comes to work on a press, is chosen, and goes back. */
class GanttModelTest {
    private static final String PLAN = """
        {"formatVersion": 1, "id": "p", "name": "P", "domain": "crw", "plans": [{
          "id": "p", "name": "Two phases",
          "places": [{"id": "start", "name": "Start", "start": true},
            {"id": "work", "name": "Work", "outputs": [{"id": "ask", "type": "OperatorSelectBoatList",
              "markups": [{"type": "PhaseItem", "options": {"phaseName": "Choose", "actor": "OPERATOR"}}]}]},
            {"id": "rest", "name": "Rest"}, {"id": "end", "end": true}],
          "transitions": [
            {"id": "go", "inputs": [{"id": "i1", "type": "OperatorInterruptReceived", "fields": {"interruptName": "Go"},
              "markups": [{"type": "PhaseItem", "options": {"phaseName": "Begin", "actor": "OPERATOR"}}]}]},
            {"id": "picked", "inputs": [{"id": "i3", "type": "OperatorSelectsBoatList"}]},
            {"id": "over", "inputs": [{"id": "i4", "type": "OperatorInterruptReceived", "fields": {"interruptName": "Over"}}]}],
          "inEdges": [
            {"id": "e1", "place": "start", "transition": "go", "requirements": [{"match": "at-least", "n": 1, "kind": "any-proxy"}]},
            {"id": "e3", "place": "work", "transition": "picked", "requirements": [{"match": "at-least", "n": 1, "kind": "any-proxy"}]},
            {"id": "e4", "place": "start", "transition": "over", "requirements": [{"match": "at-least", "n": 1, "kind": "generic"}]}],
          "outEdges": [
            {"id": "o1", "transition": "go", "place": "work", "requirements": [{"action": "take", "n": "all", "kind": "any-proxy"}]},
            {"id": "o3", "transition": "picked", "place": "rest", "requirements": [{"action": "take", "n": "all", "kind": "any-proxy"}]},
            {"id": "o4", "transition": "over", "place": "end", "requirements": [{"action": "take", "n": "all", "kind": "any-token"}]}]}]}
        """;

    private final ModelWorld world = new ModelWorld(PLAN);

    @BeforeEach
    void aMissionOfOneBoatRuns() {
        at(0, new Input.ProxyJoined("anna"), ModelWorld.start("first"));
    }

    private void at(long millis, Input... inputs) {
        world.nowMillis.set(millis);
        world.step(inputs);
        world.settle();
    }

    private void choose(long millis) {
        long decision = world.host.ask(EngineView::decisions).get(0).id();
        at(millis, new Input.AnswerDecision(decision, new Answer.Proxies(List.of("anna")), Answerer.OPERATOR));
    }

    private GanttMission mission() {
        return world.models.gantt().mission(1).orElseThrow();
    }

    private List<GanttBar> phase(String name) {
        return mission().phases().stream()
                .filter(phase -> phase.name().equals(name))
                .findFirst()
                .map(GanttPhase::bars)
                .orElseThrow();
    }

    private static GanttBar bar(String label, long from, OptionalLong until) {
        return new GanttBar(label, from, false, until);
    }

    @Test
    void aRobotIsAtThePlaceToWhichItCameLast() {
        at(5_000, new Input.Interrupt(1, "Go", List.of("anna")));
        choose(9_000);

        assertThat(mission().robots())
                .containsExactly(new GanttRow(
                        "anna",
                        List.of(
                                bar("Start", 0, OptionalLong.of(5_000)),
                                bar("Work", 5_000, OptionalLong.of(9_000)),
                                bar("Rest", 9_000, OptionalLong.empty()))));
    }

    @Test
    void aPhaseGoesOnWhileAnActionOfItDoesAndUntilTheNextBegins() {
        assertThat(mission().phases())
                .extracting(GanttPhase::name, GanttPhase::status)
                .containsExactly(tuple("Begin", Status.AHEAD), tuple("Choose", Status.AHEAD));

        at(5_000, new Input.Interrupt(1, "Go", List.of("anna")));
        assertThat(phase("Choose")).containsExactly(bar("Choose", 5_000, OptionalLong.empty()));
        assertThat(mission().status("ask")).isEqualTo(Status.ACTIVE);

        choose(9_000);
        assertThat(phase("Choose"))
                .as("until an action of another phase begins")
                .containsExactly(bar("Choose", 5_000, OptionalLong.empty()));
        assertThat(mission().status("ask")).isEqualTo(Status.DONE);
    }

    @Test
    void whatTakesNoTimeHasABarWithoutLength() {
        at(5_000, new Input.Interrupt(1, "Go", List.of("anna")));

        assertThat(mission().phases().get(0).actions())
                .singleElement()
                .satisfies(action -> assertThat(action.bars())
                        .singleElement()
                        .satisfies(bar -> assertThat(bar.untilMillis()).hasValue(5_000)));
    }

    @Test
    void anEndedMissionHasNothingThatGoesOn() {
        at(5_000, new Input.Interrupt(1, "Go", List.of("anna")));
        at(7_000, new Input.AbortMission(1));

        assertThat(mission().endedAtMillis()).hasValue(7_000);
        assertThat(phase("Choose")).containsExactly(bar("Choose", 5_000, OptionalLong.of(7_000)));
        assertThat(mission().robots().get(0).bars()).noneMatch(GanttBar::goesOn);
    }

    @Test
    void afterARestoreItIsSaidThatWhatGoesOnBeganBefore() {
        at(5_000, new Input.Interrupt(1, "Go", List.of("anna")));
        OperatorModels later = new OperatorModels(Runnable::run);

        world.host.ask(view -> {
            later.restore(view, 60_000);
            return Map.of();
        });

        GanttMission restored = later.gantt().mission(1).orElseThrow();
        assertThat(restored.startedAtMillis()).isZero();
        assertThat(restored.robots())
                .containsExactly(
                        new GanttRow("anna", List.of(new GanttBar("Work", 60_000, true, OptionalLong.empty()))));
        assertThat(restored.status("ask")).isEqualTo(Status.ACTIVE);
    }
}
