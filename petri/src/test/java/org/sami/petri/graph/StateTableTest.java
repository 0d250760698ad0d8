package org.sami.petri.graph;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.function.IntFunction;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class StateTableTest {
    private static final int COUNT = 50_000;

    /** States that differ in one part of a word only. */
    static Stream<IntFunction<long[]>> states() {
        return Stream.of(
                i -> new long[] {i},
                i -> new long[] {(long) i << 40},
                i -> new long[] {(long) i << 16 | 7},
                i -> new long[] {5, i},
                i -> new long[] {i, 5},
                i -> new long[] {1, (long) i << 47, 3},
                i -> new long[] {0, 0, 0, (long) i << 20});
    }

    @ParameterizedTest
    @MethodSource("states")
    void statesThatDifferAnywhereAreDifferent(IntFunction<long[]> states) {
        StateTable table = new StateTable(states.apply(0).length);
        for (int i = 0; i < COUNT; i++) {
            if (table.isFull()) {
                table.grow(table.slots() * 7 / 4);
            }
            assertThat(table.add(states.apply(i))).isEqualTo(i);
        }

        assertThat(table.count()).isEqualTo(COUNT);
        long[] loaded = new long[states.apply(0).length];
        for (int i = 0; i < COUNT; i += 11) {
            assertThat(table.add(states.apply(i))).isEqualTo(i);
            assertThat(table.find(states.apply(i))).isEqualTo(i);
            table.load(i, loaded);
            assertThat(loaded).containsExactly(states.apply(i));
        }
        assertThat(table.count()).isEqualTo(COUNT);
        assertThat(table.find(states.apply(COUNT))).isEqualTo(-1);
    }
}
