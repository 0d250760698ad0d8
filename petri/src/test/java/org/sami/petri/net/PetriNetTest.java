package org.sami.petri.net;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;

class PetriNetTest {
    private final PetriNetBuilder builder = new PetriNetBuilder("small");

    @Test
    void arcsAreSortedByPlaceAndParallelOnesAreOne() {
        int a = builder.place("a", 1);
        int b = builder.place("b", 0);
        int idle = builder.transition("idle");
        int t = builder.transition("t");
        builder.consume(t, b, 2)
                .consume(t, a, 1)
                .consume(t, b, 3)
                .inhibit(t, a, 4)
                .inhibit(t, a, 2);

        PetriNet net = builder.build();

        ArcTable consumed = net.consumed();
        assertThat(consumed.isEmpty(idle)).isTrue();
        assertThat(consumed.to(t) - consumed.from(t)).isEqualTo(2);
        assertThat(consumed.node(consumed.from(t))).isEqualTo(a);
        assertThat(consumed.weight(t, b)).isEqualTo(5);
        assertThat(consumed.weight(idle, b)).isZero();
        assertThat(net.inhibitors().weight(t, a)).isEqualTo(2);
        assertThat(net.isPlain()).isFalse();
    }

    @Test
    void tableSeenFromPlacesHasTheSameArcs() {
        List<String> places = List.of("a", "b", "c");
        places.forEach(place -> builder.place(place, 0));
        int first = builder.move("first", List.of("c", "a"), List.of());
        int second = builder.move("second", List.of("c"), List.of());

        ArcTable consumers = builder.build().consumed().transposed(places.size());

        assertThat(consumers.rows()).isEqualTo(3);
        assertThat(consumers.isEmpty(1)).isTrue();
        assertThat(List.of(consumers.node(consumers.from(2)), consumers.node(consumers.from(2) + 1)))
                .containsExactly(first, second);
        assertThat(consumers.weight(0, first)).isEqualTo(1);
    }

    @Test
    void transitionConsumesThenResetsThenProduces() {
        int a = builder.place("a", 5);
        int b = builder.place("b", 7);
        int t = builder.transition("t");
        builder.consume(t, a, 2).reset(t, a).produce(t, a, 1).reset(t, b).inhibit(t, b, 8);
        PetriNet net = builder.build();

        assertThat(FiringRule.fire(net, t, net.initialMarking())).containsExactly(1, 0);
        assertThat(FiringRule.isEnabled(net, t, new int[] {1, 0})).isFalse();
        assertThat(FiringRule.isEnabled(net, t, new int[] {2, 8})).isFalse();
        assertThatThrownBy(() -> FiringRule.fire(net, t, new int[] {0, 0})).hasMessageContaining("t is not enabled");
    }

    @Test
    void firingNeverOverflowsInSilence() {
        int a = builder.place("a", Integer.MAX_VALUE);
        int t = builder.transition("t");
        builder.produce(t, a, 1);
        PetriNet net = builder.build();

        assertThatThrownBy(() -> FiringRule.fire(net, t, net.initialMarking())).isInstanceOf(ArithmeticException.class);
    }

    @Test
    void placeAndTransitionMayHaveTheSameId() {
        builder.place("x", "Place x", 3);
        builder.transition("x", "Transition x");

        PetriNet net = builder.build();

        assertThat(net.place("x")).hasValue(0);
        assertThat(net.transition("x")).hasValue(0);
        assertThat(net.place("y")).isEmpty();
        assertThat(net.placeName(0)).isEqualTo("Place x");
        assertThat(net.transitionName(0)).isEqualTo("Transition x");
        assertThat(net.initialMarking()).containsExactly(3);
    }

    @Test
    void refusesWhatMakesNoSenseByName() {
        builder.place("a", 0);
        int t = builder.transition("t");

        assertThatThrownBy(() -> builder.place("a", 0)).hasMessage("there is a place with the id a already");
        assertThatThrownBy(() -> builder.place("b", -1)).hasMessage("place b cannot have -1 tokens");
        assertThatThrownBy(() -> builder.consume(t, 5, 1)).hasMessage("there is no place with the number 5");
        assertThatThrownBy(() -> builder.produce(1, 0, 1)).hasMessage("there is no transition with the number 1");
        assertThatThrownBy(() -> builder.consume(t, 0, 0))
                .hasMessage("arc between transition t and place a cannot have the weight 0");
        assertThatThrownBy(() -> builder.placeNumber("b")).hasMessage("there is no place with the id b");
        builder.produce(t, 0, Integer.MAX_VALUE).produce(t, 0, 1);
        assertThatThrownBy(builder::build).hasMessageContaining("transition t and place a sum up to 2147483648");
    }
}
