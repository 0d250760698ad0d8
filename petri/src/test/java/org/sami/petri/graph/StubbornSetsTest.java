package org.sami.petri.graph;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.sami.petri.net.PetriNet;
import org.sami.petri.net.PetriNetBuilder;

/** Stubborn sets of nets in which each transition depends on each other one. */
class StubbornSetsTest {
    private static final int TRANSITIONS = 5_000;

    /** Transitions that all test one place; each takes a token of another place, so that the net stops after a few firings. */
    private static PetriNet allTestOnePlace() {
        PetriNetBuilder net = new PetriNetBuilder("test");
        net.place("tested", 1);
        net.place("tokens", 3);
        for (int t = 0; t < TRANSITIONS; t++) {
            net.transition("t" + t);
            net.consume(t, 0, 1).produce(t, 0, 1).consume(t, 1, 1);
        }
        return net.build();
    }

    @Test
    void choiceThatVisitsTooManyRelationsKeepsAllEnabledTransitions() {
        PetriNet net = allTestOnePlace();
        StubbornSets sets = new StubbornSets(net);
        int[] all = IntStream.range(0, TRANSITIONS).toArray();
        int[] list = all.clone();

        int count = sets.choose(net.initialMarking(), list, TRANSITIONS);

        assertThat(count).isEqualTo(TRANSITIONS);
        assertThat(list).containsExactly(all);
        assertThat(sets.visited()).isBetween((long) StubbornSets.MOST_VISITED, StubbornSets.MOST_VISITED + 5_000L);
    }

    @Test
    void smallestSetThatWasClosedIsKeptWhereALaterOneVisitsTooMuch() {
        PetriNetBuilder builder = new PetriNetBuilder("alone");
        builder.place("tested", 1);
        builder.place("pair", 1);
        for (int t = 0; t < 2; t++) {
            builder.transition("pair" + t);
            builder.consume(t, 1, 1);
        }
        for (int t = 2; t < TRANSITIONS; t++) {
            builder.transition("t" + t);
            builder.consume(t, 0, 1).produce(t, 0, 1);
            builder.produce(t, builder.place("p" + t, 0), 1);
        }
        PetriNet net = builder.build();
        int[] list = IntStream.range(0, TRANSITIONS).toArray();

        int count = new StubbornSets(net).choose(net.initialMarking(), list, TRANSITIONS);

        assertThat(count).isEqualTo(2);
        assertThat(list[0] + list[1]).isEqualTo(1);
    }

    @Test
    void deadlockIsFoundWithAndWithoutReductionWhereAllTransitionsTestOnePlace() {
        SearchSettings settings = SearchSettings.within(SearchBudget.ofStates(1_000));

        ReachabilityGraph whole = ReachabilitySearch.explore(allTestOnePlace(), settings);
        ReachabilityGraph reduced = ReachabilitySearch.explore(allTestOnePlace(), settings.withReduction());

        assertThat(whole.isComplete()).isTrue();
        assertThat(reduced.isComplete()).isTrue();
        assertThat(whole.deadlocks()).hasSize(1);
        assertThat(reduced.marking(reduced.deadlocks().get(0)))
                .containsExactly(whole.marking(whole.deadlocks().get(0)));
    }

    @Test
    void dependentTransitionsThatAreKeptHaveABoundAndTheOthersAreTheSame() {
        TransitionRelations relations = new TransitionRelations(allTestOnePlace());

        for (int t = 0; t < TRANSITIONS; t++) {
            assertThat(relations.dependentOn(t).length).isEqualTo(TRANSITIONS - 1);
        }

        assertThat(relations.kept())
                .isBetween(TransitionRelations.MOST_KEPT - TRANSITIONS, TransitionRelations.MOST_KEPT);
        assertThat(relations.dependentOn(TRANSITIONS - 1))
                .containsExactly(IntStream.range(0, TRANSITIONS - 1).toArray());
    }
}
