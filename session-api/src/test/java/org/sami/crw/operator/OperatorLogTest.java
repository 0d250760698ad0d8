package org.sami.crw.operator;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.crw.operator.OperatorLogEntry.Kind;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.TextValue;

class OperatorLogTest {
    private final ModelWorld world = new ModelWorld();
    private final OperatorLog log = world.models.log();

    private List<String> texts() {
        world.settle();
        return log.snapshot().stream().map(OperatorLogEntry::text).toList();
    }

    @Test
    void whatTheEngineCarriedOutIsLoggedInWords() {
        world.step(new Input.ProxyJoined("anna"), ModelWorld.start("test"));
        world.step(new Input.Interrupt(1, "Go", List.of("anna")));
        world.step(new Input.AnswerDecision(1, new Answer.Proxies(List.of("anna")), Answerer.OPERATOR));
        world.step(new Input.SetVariable(1, "@note", new TextValue("weeds")));
        world.step(new Input.ProxyDropped("anna", 1), new Input.AbortMission(Ids.NONE));

        assertThat(texts())
                .containsExactly(
                        "started p as mission 1",
                        "pressed Go for anna in mission 1",
                        "answered [1] Operator Select Boat List (Work): anna",
                        "set @note = weeds",
                        "dropped anna from mission 1",
                        "aborted all missions");
        assertThat(log.snapshot()).extracting(OperatorLogEntry::number).containsExactly(1L, 2L, 3L, 4L, 5L, 6L);
    }

    @Test
    void whatWasRefusedOrAnsweredByAutonomyIsNotLogged() {
        world.step(new Input.StartMission("none", "", Map.of()), new Input.AbortMission(7));
        world.step(new Input.ProxyJoined("anna"), ModelWorld.start("test"));
        world.step(new Input.Interrupt(1, "Back", List.of("anna")));
        world.step(new Input.Interrupt(1, "Go", List.of("anna")));
        world.step(new Input.AnswerDecision(1, new Answer.Proxies(List.of("anna")), Answerer.AUTONOMY));

        assertThat(texts()).containsExactly("started p as mission 1", "pressed Go for anna in mission 1");
    }

    @Test
    void stepsThatAreHeardOfAgainAreNotLoggedAgain() {
        world.host.ask(view -> {
            world.models.onPastStep(0, new Input.AbortMission(Ids.NONE), List.of(), view);
            return null;
        });

        assertThat(texts()).isEmpty();
    }

    @Test
    void noteHasItsTimeAndPlaceAndIsKeptAtOnce() {
        List<OperatorLogEntry> kept = new ArrayList<>();
        log.keepWith(kept::add);
        world.nowMillis.set(61_000);
        log.note("weeds here", Optional.of(GeoPoint.of(45, 10)));

        assertThat(kept)
                .containsExactly(new OperatorLogEntry(
                        1, 61_000, Kind.NOTE, "weeds here", Ids.NONE, List.of(), Optional.of(GeoPoint.of(45, 10))));
        assertThat(texts()).containsExactly("weeds here");
    }

    @Test
    void numbersGoOnBehindWhatEarlierProcessesKept() {
        log.restore(List.of(new OperatorLogEntry(41, 5, Kind.NOTE, "earlier", Ids.NONE, List.of(), Optional.empty())));
        log.note("now", Optional.empty());

        assertThat(texts()).containsExactly("earlier", "now");
        assertThat(log.snapshot().get(1).number()).isEqualTo(42);
    }
}
